"""Pictures that lie on the table: orientation, content, and what they have to agree with."""

import io

import numpy as np
import pytest
import trimesh

from app.views.field import laid_over, print_workspace
from app.views.palette import BLOCK_COLOURS, LIGHT, surface
from app.views.pusher import PUSHER_HEIGHT, PUSHER_SIDE
from app.views.shadows import ORIGIN_HEIGHT, shadow, shadow_glb
from app.views.table import MARGIN, print_rim
from app.views.table_marks import RIM_SCALE, WORKSPACE_PIXELS, rim_marks, workspace_marks
from singulate.geometry import Workspace
from singulate.simulation import Physics, palette

WORKSPACE = Workspace()


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


def test_numerals_stand_on_the_rim_and_the_grid_on_the_workspace() -> None:
    rim = rim_marks(WORKSPACE, MARGIN, LIGHT)
    inked = (rim != LIGHT.table).any(axis=-1)
    margin = round(MARGIN * RIM_SCALE)
    assert inked[-margin:, :].any() and inked[:, :margin].any()
    assert not inked[: margin // 2, len(rim) // 2 :].any()
    assert not inked[margin:-margin, margin:-margin].any(), "a field would hide it"

    grid = (workspace_marks(WORKSPACE, LIGHT) != LIGHT.table).any(axis=-1)
    assert grid[WORKSPACE_PIXELS // 2 - 1 : WORKSPACE_PIXELS // 2 + 1].all(axis=1).any()
    assert 0.0 < grid.mean() < 0.05


@pytest.mark.parametrize("is_dark", [False, True])
def test_strips_of_the_rim_lie_around_the_workspace_and_nowhere_twice(is_dark: bool) -> None:
    strips = print_rim(WORKSPACE, is_dark)
    covered = 0.0
    for strip in strips:
        height, width, _ = strip.picture.shape
        assert (width, height) == pytest.approx(np.array(strip.size) * RIM_SCALE)
        outer = np.abs(strip.centre) + np.array(strip.size) / 2
        assert outer.max() == pytest.approx(WORKSPACE.half_length + MARGIN)
        covered += strip.size[0] * strip.size[1]
    table = (WORKSPACE.length + 2 * MARGIN) ** 2
    assert covered == pytest.approx(table - WORKSPACE.length**2)
    below = strips[0].picture
    assert (below[len(below) // 3 :] != surface(is_dark).table).any(), "numerals and border"


def test_a_field_covers_the_print_as_far_as_it_is_opaque() -> None:
    bare = print_workspace(WORKSPACE, False)
    field = np.zeros((320, 320, 4), np.uint8)
    field[:160] = (200, 100, 0, 255)
    field[160:240] = (200, 100, 0, 51)
    laid = laid_over(bare, field)
    assert (laid[:320] == (200, 100, 0)).all()
    assert np.array_equal(laid[480:], bare[480:])
    expected = 0.2 * np.array([200, 100, 0]) + 0.8 * bare[320:480]
    assert np.abs(laid[320:480] - expected).max() <= 0.5
