import math

import numpy as np
import pytest

from singulate.perception import Percept
from singulate.rewards import is_success, success_reward


def percept(num_segments: int, separations: list[float]) -> Percept:
    labels = np.zeros((64, 64), np.int32)
    labels[0, : 2 * num_segments : 2] = np.arange(1, num_segments + 1)
    return Percept(int(labels.max()), np.array(separations), labels > 0, labels)


def test_two_blocks_far_enough_apart() -> None:
    assert is_success(percept(2, [0.125]), num_blocks=2, goal=0.1)


def test_two_blocks_too_close() -> None:
    assert not is_success(percept(2, [0.09375]), num_blocks=2, goal=0.1)


def test_the_goal_itself_is_enough() -> None:
    assert is_success(percept(2, [0.125]), num_blocks=2, goal=0.125)
    assert not is_success(percept(2, [0.125]), num_blocks=2, goal=math.nextafter(0.125, 1.0))


def test_one_close_pair_spoils_it() -> None:
    assert is_success(percept(3, [0.2, 0.5, 0.1]), num_blocks=3, goal=0.1)
    assert not is_success(percept(3, [0.2, 0.5, 0.01]), num_blocks=3, goal=0.1)


def test_segments_that_hide_a_block_are_no_success() -> None:
    assert not is_success(percept(2, [0.5]), num_blocks=3, goal=0.1)
    assert not is_success(percept(1, []), num_blocks=2, goal=0.1)


def test_a_segment_too_many_is_no_success() -> None:
    assert not is_success(percept(3, [0.5, 0.5, 0.5]), num_blocks=2, goal=0.1)


def test_one_block_is_singulated_if_it_is_seen() -> None:
    assert is_success(percept(1, []), num_blocks=1, goal=0.1)
    assert not is_success(percept(0, []), num_blocks=1, goal=0.1)


def test_result_is_a_plain_bool() -> None:
    assert is_success(percept(2, [0.5]), 2, 0.1) is True
    assert is_success(percept(2, [0.0]), 2, 0.1) is False


@pytest.mark.parametrize("seed", range(40))
def test_the_same_as_equation_6_for_the_truncated_distance(seed: int) -> None:
    rng = np.random.default_rng(seed)
    num_blocks, goal = int(rng.integers(2, 6)), 0.125
    num_pairs = math.comb(num_blocks, 2)
    # Multiples of 1/32 m are summed without rounding.
    seen = percept(num_blocks, list(rng.integers(3, 12 + seed, num_pairs) / 32.0))
    expected = seen.inter_object_distance_truncated(goal) >= num_pairs * goal
    assert is_success(seen, num_blocks, goal) is expected


def test_reward() -> None:
    assert success_reward(True) == 1.0
    assert success_reward(False) == 0.0
