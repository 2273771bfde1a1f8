import pickle

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.rewards import TERMS, RewardFunction, make_reward

VALUES = {"start": 0.5, "distance": 0.2, "inside": 1.0, "success": 1.0}


def test_equation_7() -> None:
    assert make_reward("paper").total(VALUES) == pytest.approx(150.0 + 200.0 - 100.0 + 1000.0)


def test_shares_by_term() -> None:
    shares = make_reward("paper").weighted(VALUES)
    assert shares == pytest.approx(
        {"start": 150.0, "distance": 200.0, "inside": -100.0, "success": 1000.0}
    )
    assert tuple(shares) == TERMS


def test_a_term_without_weight_counts_nothing() -> None:
    reward = RewardFunction("one", {"inside": -2.0})
    assert reward.weighted(VALUES) == {"start": 0, "distance": 0, "inside": -2.0, "success": 0}
    assert reward.total(VALUES) == -2.0


def test_warmup_weights_hold_for_exactly_the_first_pushes() -> None:
    reward = RewardFunction("scheduled", {"distance": 20.0}, 3, {"start": 4.0})
    totals = [reward.total(VALUES, num_pushes) for num_pushes in range(5)]
    assert totals == [2.0, 2.0, 2.0, 4.0, 4.0]
    shares = [reward.weighted(VALUES, num_pushes)["start"] for num_pushes in range(5)]
    assert shares == [2.0, 2.0, 2.0, 0.0, 0.0]
    assert reward.weights_at(2) == {"start": 4.0}
    assert reward.weights_at(3) == {"distance": 20.0}


def test_a_missing_term_is_an_error() -> None:
    with pytest.raises(KeyError, match="success"):
        make_reward("paper").total({"start": 0.0, "distance": 0.0, "inside": 0.0})


@pytest.mark.parametrize("keyword", ["weights", "warmup_weights"])
def test_a_weight_for_no_term_is_refused(keyword: str) -> None:
    weights = {"weights": {}, "warmup_weights": {}, keyword: {"bonus": 1.0}}
    with pytest.raises(InvalidValueError, match=r"'bonus'.*start, distance, inside, success"):
        RewardFunction("wrong", num_warmup_pushes=0, **weights)


def test_a_negative_warmup_is_refused() -> None:
    with pytest.raises(InvalidValueError, match="num_warmup_pushes: -1"):
        RewardFunction("wrong", {}, num_warmup_pushes=-1)


def test_survives_pickling() -> None:
    reward = make_reward("start_then_separation")
    assert pickle.loads(pickle.dumps(reward)) == reward


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("name", ["paper", "separation", "start", "start_then_separation"])
def test_total_is_the_sum_of_the_shares_and_linear(name: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    reward, num_pushes = make_reward(name), int(rng.integers(0, 80_000))
    a, b = (dict(zip(TERMS, map(float, rng.normal(size=4)), strict=True)) for _ in range(2))
    both = {term: a[term] + b[term] for term in TERMS}
    assert reward.total(a, num_pushes) == pytest.approx(
        sum(reward.weighted(a, num_pushes).values())
    )
    assert reward.total(both, num_pushes) == pytest.approx(
        reward.total(a, num_pushes) + reward.total(b, num_pushes)
    )
