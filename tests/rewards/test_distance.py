import pytest

from singulate.rewards import distance_reward


def test_moving_apart_pays_the_metres_gained() -> None:
    assert distance_reward(before_m=0.0, after_m=0.1) == pytest.approx(0.1)


def test_moving_together_costs_the_metres_lost() -> None:
    assert distance_reward(before_m=0.25, after_m=0.05) == pytest.approx(-0.2)


def test_nothing_moved_is_worth_nothing() -> None:
    assert distance_reward(before_m=0.07, after_m=0.07) == 0.0
