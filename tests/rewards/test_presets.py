import pytest

from singulate.exceptions import InvalidValueError
from singulate.rewards import REWARDS, make_reward

VALUES = {"start": 0.5, "distance": 0.25, "inside": 1.0, "success": 1.0}


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("paper", 150.0 + 250.0 - 100.0 + 1000.0),
        ("separation", 250.0),
        ("start", 150.0 - 100.0),
    ],
)
def test_totals_at_any_time(name: str, expected: float) -> None:
    reward = make_reward(name)
    assert reward.name == name
    for num_pushes in (0, 39_999, 40_000, 1_000_000):
        assert reward.total(VALUES, num_pushes) == pytest.approx(expected)


def test_the_schedule_switches_after_40_000_pushes() -> None:
    reward = make_reward("start_then_separation")
    assert reward.total(VALUES, 0) == pytest.approx(50.0)
    assert reward.total(VALUES, 39_999) == pytest.approx(50.0)
    assert reward.total(VALUES, 40_000) == pytest.approx(250.0)
    assert reward.total(VALUES, 100_000) == pytest.approx(250.0)


def test_names() -> None:
    assert sorted(REWARDS) == ["paper", "separation", "start", "start_then_separation"]


@pytest.mark.parametrize("name", ["", "Paper", "sparse"])
def test_an_unknown_name_is_refused_in_one_line(name: str) -> None:
    with pytest.raises(InvalidValueError) as caught:
        make_reward(name)
    message = str(caught.value)
    assert message.startswith(f"reward: {name!r} is not allowed")
    assert "paper, separation, start, start_then_separation" in message
    assert "\n" not in message


@pytest.mark.parametrize("name", [["paper"], {}, None, 3])
def test_a_name_of_a_wrong_type_is_refused(name: object) -> None:
    with pytest.raises(InvalidValueError, match="reward: "):
        make_reward(name)  # type: ignore[arg-type]
