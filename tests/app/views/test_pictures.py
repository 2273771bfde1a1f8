"""Pictures that lie on the table: orientation, content, and what they have to agree with."""

import io

import numpy as np
import trimesh

from app.views.palette import BLOCK_COLOURS, LIGHT
from app.views.pusher import PUSHER_HEIGHT, PUSHER_SIDE
from app.views.shadows import ORIGIN_HEIGHT, shadow, shadow_glb
from app.views.table_marks import PIXELS, table_marks
from singulate.geometry import Workspace
from singulate.simulation import Physics, palette


def test_colours_and_sizes_are_those_of_the_simulation() -> None:
    for colour, (*rgb, _alpha) in zip(BLOCK_COLOURS, palette.BLOCK_COLOURS, strict=True):
        assert np.abs(np.array(colour) / 255 - rgb).max() < 0.005
    assert Physics().pusher_side == PUSHER_SIDE
    assert Physics().pusher_height == PUSHER_HEIGHT


def test_a_shadow_is_as_large_as_its_block_and_soft() -> None:
    alpha = shadow()[..., 3].astype(float)
    cell = 2 * 0.85 / len(alpha)
    assert abs((alpha / alpha.max()).sum() * cell**2 - 1.0) < 0.05
    assert np.array_equal(alpha, alpha[::-1]) and np.array_equal(alpha, alpha.T)
    assert alpha[0].max() < 0.02 * alpha.max() < np.median(alpha)


def test_a_shadow_lies_flat_below_its_origin() -> None:
    sheet = trimesh.load(io.BytesIO(shadow_glb()), file_type="glb").to_geometry()
    assert np.allclose(sheet.vertices[:, 2], -ORIGIN_HEIGHT)
    assert np.allclose(np.ptp(sheet.vertices[:, :2], axis=0), 2 * 0.85)
    assert (sheet.face_normals[:, 2] > 0).all()


def test_numerals_stand_beside_the_workspace_and_the_grid_inside() -> None:
    marks = table_marks(Workspace(), 0.12, LIGHT)
    assert marks.shape == (PIXELS, PIXELS, 3)
    inked = (marks != LIGHT.table).any(axis=-1)
    border = round(PIXELS * 0.12 / 2.24)
    assert inked[-border:, :].any() and inked[:, :border].any()
    assert not inked[: border // 2, PIXELS // 2 :].any()
    assert inked[PIXELS // 2, border + 50 : -border - 50].all()
