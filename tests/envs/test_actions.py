"""Actions as pushes."""

import numpy as np
import pytest

from singulate.envs import GridActions, PointActions, StartEndActions
from singulate.geometry import Direction, Push, Workspace

WORKSPACE = Workspace()


@pytest.mark.parametrize(
    ("action", "start", "direction"),
    [
        (0, (-0.9, 0.9), Direction.UP),
        (9, (0.9, 0.9), Direction.UP),
        (110, (-0.9, 0.7), Direction.RIGHT),
        (299, (0.9, -0.9), Direction.DOWN),
        (399, (0.9, -0.9), Direction.LEFT),
    ],
)
def test_a_grid_action_is_direction_row_and_column(action, start, direction):
    push = GridActions(WORKSPACE).decode(action)
    assert push.start == pytest.approx(start)
    assert push.direction == direction.vector
    assert push.length == 0.5


def test_encoding_is_the_inverse_of_decoding_on_the_grid():
    grid = GridActions(WORKSPACE)
    assert [grid.encode(grid.decode(a)) for a in range(400)] == list(range(400))


@pytest.mark.parametrize(
    ("c", "direction"),
    [
        (-1.0, Direction.UP),
        (-0.51, Direction.UP),
        (-0.49, Direction.RIGHT),
        (0.0, Direction.DOWN),
        (0.51, Direction.LEFT),
        (1.0, Direction.LEFT),
    ],
)
def test_four_equal_bins_of_c_pick_the_direction(c, direction):
    push = PointActions(WORKSPACE).decode(np.array([0.25, -0.5, c], dtype=np.float32))
    assert push == Push.cardinal((0.25, -0.5), direction, 0.5)


def test_a_push_survives_encoding_and_decoding():
    push = Push.cardinal((0.25, -0.5), Direction.LEFT, 0.5)
    for encoding in (PointActions(WORKSPACE), StartEndActions(WORKSPACE)):
        again = encoding.decode(encoding.encode(push))
        assert again.start == pytest.approx(push.start)
        assert again.direction == pytest.approx(push.direction)
        assert again.length == pytest.approx(push.length)


def test_a_push_over_the_border_is_encoded_up_to_the_border():
    push = Push.cardinal((0.0, 0.75), Direction.UP, 0.5)
    assert StartEndActions(WORKSPACE).encode(push).tolist() == [0.0, 0.75, 0.0, 1.0]


def test_start_and_end_give_direction_and_length():
    push = StartEndActions(Workspace(half_length=2.0)).decode(np.array([0.0, 0.0, 0.3, 0.4]))
    assert push.start == (0.0, 0.0)
    assert push.end == pytest.approx((0.6, 0.8))
    assert push.length == pytest.approx(1.0)
