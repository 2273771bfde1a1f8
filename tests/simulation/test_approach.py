import math

import pytest

from singulate.geometry import Block, Direction, Push, Workspace, standing_pose
from singulate.simulation import Scene
from singulate.simulation.approach import SWEEP_MARGIN, block_intervals, free_length, is_blocked

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
    assert free_length(poses, push, 0.06) == pytest.approx(
        0.5 - 0.1 * math.sqrt(2) - 0.03 - SWEEP_MARGIN
    )


def test_a_strip_cuts_the_part_of_a_block_that_reaches_into_it() -> None:
    poses = (standing_pose(Block(0.0, 0.0, 0.2, math.pi / 4)),)
    reach = 0.1 * math.sqrt(2)
    ((first, last),) = block_intervals(poses, (-0.5, reach), (1.0, 0.0), 0.05)
    assert (first, last) == pytest.approx((0.45, 0.55))


@pytest.mark.parametrize(("x", "expected"), [(0.12, True), (0.13, False), (0.14, False)])
def test_a_start_is_blocked_where_the_pusher_would_land_on_a_block(
    x: float, expected: bool
) -> None:
    # The block ends at x = 0.1, the pusher 0.03 m before its middle: at 0.13 they merely touch.
    for direction in Direction:
        assert is_blocked(BLOCK, Push.cardinal((x, 0.0), direction, 0.5), 0.06) == expected


@pytest.mark.parametrize("yaw", [0.0, 0.3])
def test_a_pusher_that_passes_at_more_than_the_margin_moves_nothing(yaw: float) -> None:
    block = Block(0.0, 0.0, 0.2, yaw)
    reach = 0.1 * (math.cos(yaw) + math.sin(yaw))
    ends = []
    with Scene(Workspace(), exact=True) as scene:
        for gap in (-SWEEP_MARGIN, 1.2 * SWEEP_MARGIN, 0.3):
            scene.place((block,))
            push = Push.cardinal((reach + 0.03 + gap, -0.25), Direction.UP, 0.5)
            assert scene.touches(push) == (gap < SWEEP_MARGIN)
            scene.push(push)
            ends.append(scene.poses[0].position)
    assert math.dist(ends[0], ends[2]) > 1e-4
    assert math.dist(ends[1], ends[2]) < 1e-9
