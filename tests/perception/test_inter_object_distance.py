import numpy as np
import pytest

from singulate.perception import inter_object_distance, truncated_inter_object_distance

SEPARATIONS = np.array([0.05, 0.3, 0.12])


def test_d_io_is_the_sum() -> None:
    assert inter_object_distance(SEPARATIONS) == pytest.approx(0.47)


def test_d_iot_counts_each_pair_up_to_the_goal() -> None:
    assert truncated_inter_object_distance(SEPARATIONS, goal=0.1) == pytest.approx(0.25)


def test_a_goal_beyond_all_separations_truncates_nothing() -> None:
    assert truncated_inter_object_distance(SEPARATIONS, goal=1.0) == pytest.approx(0.47)


def test_without_a_pair_both_are_0() -> None:
    assert inter_object_distance(np.empty(0)) == 0.0
    assert truncated_inter_object_distance(np.empty(0), goal=0.1) == 0.0


def test_results_are_plain_floats() -> None:
    assert type(inter_object_distance(SEPARATIONS)) is float
    assert type(truncated_inter_object_distance(SEPARATIONS, 0.1)) is float


@pytest.mark.parametrize("seed", range(10))
def test_d_iot_lies_between_0_and_its_bounds_and_grows_with_the_goal(seed: int) -> None:
    rng = np.random.default_rng(seed)
    separations = rng.uniform(0.0, 1.0, rng.integers(1, 20))
    goals = np.sort(rng.uniform(0.0, 1.2, 6))
    values = [truncated_inter_object_distance(separations, goal) for goal in goals]
    assert values == sorted(values)
    for goal, value in zip(goals, values, strict=True):
        bound = min(inter_object_distance(separations), len(separations) * goal)
        assert 0.0 <= value <= bound + 1e-12
