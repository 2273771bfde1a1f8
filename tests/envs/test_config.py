import pytest

from singulate.envs import EnvConfig
from singulate.exceptions import InvalidValueError


@pytest.mark.parametrize("goal", [True, "0.1", None, 0.0, 1.1, float("nan"), 10**400])
def test_the_goal_separation_is_a_number_in_range(goal: object) -> None:
    with pytest.raises(InvalidValueError, match="goal_separation: "):
        EnvConfig(goal_separation=goal)  # type: ignore[arg-type]


def test_a_reward_of_a_wrong_type_is_refused() -> None:
    with pytest.raises(InvalidValueError, match="reward: "):
        EnvConfig.from_dict({"reward": ["paper"]})
