"""The table as a flat picture."""

import math

import numpy as np

from app.views.flat_table import SIZE, flat_table
from app.views.palette import BLOCK_COLOURS
from singulate.geometry import Block, Workspace, standing_pose

WORKSPACE = Workspace()
PIXEL = WORKSPACE.length / SIZE


def rows_and_cols(picture, index):
    colour = (*BLOCK_COLOURS[index], 255)
    return np.nonzero((picture == colour).all(axis=-1))


def test_a_block_is_drawn_where_it_stands_and_as_large_as_it_is():
    poses = (standing_pose(Block(x=0.5, y=0.25, yaw=0.0, side=0.2)),)
    rows, cols = rows_and_cols(flat_table(poses, None, WORKSPACE), 0)
    left, right = 0.4 + WORKSPACE.half_length, 0.6 + WORKSPACE.half_length
    top, bottom = WORKSPACE.half_length - 0.35, WORKSPACE.half_length - 0.15
    assert np.allclose(np.array([cols.min(), cols.max() + 1]) * PIXEL, [left, right], atol=PIXEL)
    assert np.allclose(np.array([rows.min(), rows.max() + 1]) * PIXEL, [top, bottom], atol=PIXEL)


def test_a_block_turns_counter_clockwise():
    thirty = standing_pose(Block(x=0.0, y=0.0, yaw=math.radians(30.0), side=0.4))
    rows, cols = rows_and_cols(flat_table((thirty,), None, WORKSPACE), 0)
    corner = cols[rows == rows.min()].mean() * PIXEL - WORKSPACE.half_length
    reach = 0.2 * math.sqrt(2.0)
    assert abs(corner - reach * math.cos(math.radians(45.0 + 30.0))) < 4 * PIXEL


def test_blocks_hide_the_field_and_one_that_fell_is_not_drawn():
    standing = standing_pose(Block(x=0.0, y=0.0, yaw=0.0, side=0.2))
    fallen = standing._replace(position=(0.5, 0.5, -2.0))
    field = np.full((320, 320, 4), 77, np.uint8)
    picture = flat_table((standing, fallen), field, WORKSPACE)
    assert tuple(picture[SIZE // 2, SIZE // 2]) == (*BLOCK_COLOURS[0], 255)
    assert (picture[: SIZE // 3] == 77).all()
    assert not rows_and_cols(picture, 1)[0].size


def test_a_bare_table_is_transparent():
    assert not flat_table((), None, WORKSPACE).any()
