"""Pictures that lie on the table: orientation, content, and what they have to agree with."""

import math

import numpy as np

from app.views.palette import BLOCK_COLOURS, LIGHT
from app.views.pusher import PUSHER_HEIGHT, PUSHER_SIDE
from app.views.shadows import shadows
from app.views.table_marks import PIXELS, table_marks
from singulate.geometry import Block, Workspace, standing_pose
from singulate.simulation import Physics, palette


def test_colours_and_sizes_are_those_of_the_simulation() -> None:
    for colour, (*rgb, _alpha) in zip(BLOCK_COLOURS, palette.BLOCK_COLOURS, strict=True):
        assert np.abs(np.array(colour) / 255 - rgb).max() < 0.005
    assert Physics().pusher_side == PUSHER_SIDE
    assert Physics().pusher_height == PUSHER_HEIGHT


def test_shadows_lie_under_their_blocks() -> None:
    poses = (standing_pose(Block(0.5, -0.5, 0.2, 0.3)),)
    alpha = shadows(poses, reach=1.0)[..., 3].astype(float)
    rows, columns = np.indices(alpha.shape)
    cell = 2.0 / len(alpha)
    x = (alpha * ((columns + 0.5) * cell - 1.0)).sum() / alpha.sum()
    y = (alpha * ((rows + 0.5) * cell - 1.0)).sum() / alpha.sum()
    assert math.hypot(x - 0.5, y + 0.5) < 0.02
    area = (alpha / alpha.max()).sum() * cell**2
    assert abs(area - 0.04) < 0.01
    assert shadows((), reach=1.0).max() == 0


def test_numerals_stand_beside_the_workspace_and_the_grid_inside() -> None:
    marks = table_marks(Workspace(), 0.12, LIGHT)
    assert marks.shape == (PIXELS, PIXELS, 4)
    inked = marks[..., 3] > 0
    border = round(PIXELS * 0.12 / 2.24)
    assert inked[-border:, :].any() and inked[:, :border].any()
    assert not inked[: border // 2, PIXELS // 2 :].any()
    assert inked[PIXELS // 2, border + 50 : -border - 50].all()
