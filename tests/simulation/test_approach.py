import math

import pytest

from singulate.geometry import Block, Direction, Push, standing_pose
from singulate.simulation.approach import block_intervals, free_length
from singulate.simulation.footprint import SWEEP_MARGIN

BLOCK = (standing_pose(Block(0.0, 0.0, 0.2)),)


def test_the_pusher_is_free_until_its_face_is_near_the_block() -> None:
    push = Push.cardinal((0.05, -0.5), Direction.UP, 0.5)
    # The block's face at y = -0.1, less half of the pusher and the margin.
    assert free_length(BLOCK, push, 0.06) == pytest.approx(0.4 - 0.03 - SWEEP_MARGIN)


def test_blocks_beside_and_behind_are_not_in_the_way() -> None:
    beside = Push.cardinal((0.2, -0.5), Direction.UP, 0.5)
    away = Push.cardinal((0.0, 0.3), Direction.UP, 0.5)
    assert free_length(BLOCK, beside, 0.06) == math.inf
    assert free_length(BLOCK, away, 0.06) == math.inf


def test_a_turned_block_is_met_at_its_corner() -> None:
    poses = (standing_pose(Block(0.0, 0.0, 0.2, math.pi / 4)),)
    push = Push.cardinal((-0.5, 0.0), Direction.RIGHT, 0.5)
    assert free_length(poses, push, 0.06) == pytest.approx(0.5 - 0.1 * math.sqrt(2) - 0.04)


def test_a_strip_cuts_the_part_of_a_block_that_reaches_into_it() -> None:
    poses = (standing_pose(Block(0.0, 0.0, 0.2, math.pi / 4)),)
    reach = 0.1 * math.sqrt(2)
    ((first, last),) = block_intervals(poses, (-0.5, reach), (1.0, 0.0), 0.05)
    assert (first, last) == pytest.approx((0.45, 0.55))
