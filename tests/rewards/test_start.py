import math

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import CameraFrame, Direction, Push, Workspace
from singulate.perception import Percept, perceive
from singulate.rewards import object_distance, start_constants, start_reward

WORKSPACE = Workspace()
DIAGONAL = 2.0 * math.sqrt(2.0)


def percept_with_block(*corners: tuple[int, int]) -> Percept:
    depth = np.full((64, 64), 3.0, np.float32)
    for row, col in corners:
        depth[row : row + 6, col : col + 6] = 2.8
    return perceive(CameraFrame(np.zeros((64, 64, 3), np.uint8), depth, 3.0), WORKSPACE)


def push_from(x: float, y: float) -> Push:
    return Push.cardinal((x, y), Direction.UP, 0.5)


def test_constants_of_the_default_workspace() -> None:
    constants = start_constants(0.2, DIAGONAL)
    assert constants == pytest.approx((20.06664, -10.03332, 0.215218, -0.0760910), rel=1e-5)


@pytest.mark.parametrize(("goal", "diagonal"), [(0.2, DIAGONAL), (0.05, 0.7), (1.0, 9.0)])
def test_constants_meet_the_four_conditions(goal: float, diagonal: float) -> None:
    k1, k2, k3, k4 = start_constants(goal, diagonal)
    sigmoid = 1.0 / (1.0 + math.exp(-goal))
    assert k1 * 0.5 + k2 == pytest.approx(0.0, abs=1e-12)
    assert k1 * sigmoid + k2 == pytest.approx(1.0)
    assert k3 / goal + k4 == pytest.approx(1.0)
    assert k3 / diagonal + k4 == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(("goal", "diagonal"), [(0.0, 1.0), (-0.2, 1.0), (1.0, 1.0), (2.0, 1.0)])
def test_constants_need_a_goal_inside_the_workspace(goal: float, diagonal: float) -> None:
    with pytest.raises(InvalidValueError, match="goal"):
        start_constants(goal, diagonal)


@pytest.mark.parametrize(
    ("d_object", "expected"),
    [
        (0.0, 0.0),
        (0.1, 0.501242),  # 20.06664 * 0.524979 - 10.03332
        (0.2, 1.0),
        (0.4, 0.461954),  # 0.215218 / 0.4 - 0.076091
        (1.0, 0.139127),
        (DIAGONAL, 0.0),
    ],
)
def test_hand_worked_values(d_object: float, expected: float) -> None:
    assert start_reward(d_object, WORKSPACE) == pytest.approx(expected, abs=1e-5)


def test_continuous_at_the_goal() -> None:
    below, above = (start_reward(0.2 + e, WORKSPACE) for e in (-1e-9, 1e-9))
    assert below == pytest.approx(1.0, abs=1e-7)
    assert above == pytest.approx(1.0, abs=1e-7)


def test_rises_to_the_goal_then_falls_and_stays_in_0_to_1() -> None:
    distances = np.linspace(0.0, DIAGONAL, 2001)
    values = np.array([start_reward(d, WORKSPACE) for d in distances])
    slope = np.diff(values)
    assert (slope[distances[1:] <= 0.2] > 0.0).all()
    assert (slope[distances[:-1] >= 0.2] < 0.0).all()
    assert values.min() >= -1e-12
    assert values.max() <= 1.0 + 1e-12


def test_never_negative_beyond_the_diagonal() -> None:
    assert start_reward(10.0, WORKSPACE) == pytest.approx(0.0, abs=1e-12)


def test_a_larger_workspace_lets_the_reward_reach_further() -> None:
    large = Workspace(half_length=2.0)
    assert start_reward(0.2, large) == pytest.approx(1.0)
    assert start_reward(DIAGONAL, large) > 0.03
    assert start_reward(large.diagonal, large) == pytest.approx(0.0, abs=1e-12)


def test_distance_of_a_start_inside_a_block_is_0() -> None:
    percept = percept_with_block((32, 32))
    x, y = WORKSPACE.row_col_to_xy(34, 34)
    assert object_distance(percept, push_from(x, y), WORKSPACE) == 0.0


def test_distance_of_a_start_is_read_at_its_pixel() -> None:
    percept = percept_with_block((32, 32))
    for row, col, distance_px in [(34, 31, 1.0), (34, 22, 10.0), (28, 29, 5.0), (50, 35, 13.0)]:
        x, y = WORKSPACE.row_col_to_xy(row, col)
        expected = distance_px * 0.03125
        assert object_distance(percept, push_from(x, y), WORKSPACE) == pytest.approx(expected)


def test_every_point_of_a_pixel_reads_the_same() -> None:
    percept = percept_with_block((32, 32))
    x, y = WORKSPACE.row_col_to_xy(34, 22)
    for dx, dy in [(-0.015, -0.015), (0.015, 0.015), (-0.015, 0.015)]:
        push = push_from(x + dx, y + dy)
        assert object_distance(percept, push, WORKSPACE) == pytest.approx(0.3125)


def test_up_in_the_world_is_up_in_the_picture() -> None:
    percept = percept_with_block((2, 29))
    near, far = (object_distance(percept, push_from(0.0, y), WORKSPACE) for y in (0.7, -0.7))
    # Rows 9 and 54 below the block's last row, 7.
    assert near == pytest.approx(2 * 0.03125)
    assert far == pytest.approx(47 * 0.03125)


def test_an_empty_table_is_worth_no_start() -> None:
    distance = object_distance(percept_with_block(), push_from(0.3, 0.1), WORKSPACE)
    assert distance == pytest.approx(DIAGONAL, rel=1e-6)
    assert start_reward(distance, WORKSPACE) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_distance_in_the_picture_is_true_to_one_pixel(seed: int) -> None:
    rng = np.random.default_rng(seed)
    row, col = rng.integers(0, 58, 2)
    percept = percept_with_block((row, col))
    left, top = col / 32 - 1.0, 1.0 - row / 32
    for x, y in rng.uniform(-1.0, 1.0, (50, 2)):
        dx = max(left - x, 0.0, x - left - 6 / 32)
        dy = max(y - top, 0.0, top - 6 / 32 - y)
        measured = object_distance(percept, push_from(x, y), WORKSPACE)
        assert measured == pytest.approx(math.hypot(dx, dy), abs=math.sqrt(2) / 32)
