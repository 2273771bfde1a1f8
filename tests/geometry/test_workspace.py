import math

import numpy as np
import pytest

from singulate.geometry import Workspace

WORKSPACE = Workspace()


def test_sizes_of_the_default_workspace() -> None:
    assert WORKSPACE.length == 2.0
    assert WORKSPACE.diagonal == pytest.approx(2.0 * math.sqrt(2.0))
    assert WORKSPACE.push_length == 0.5
    assert WORKSPACE.metres_per_pixel == 0.03125


def test_borders_belong_to_it() -> None:
    assert WORKSPACE.contains(1.0, -1.0)
    assert not WORKSPACE.contains(math.nextafter(1.0, 2.0), 0.0)
    assert not WORKSPACE.contains(0.0, -1.001)


@pytest.mark.parametrize(
    ("xy", "row_col"),
    [
        ((-1.0, 1.0), (0, 0)),
        ((1.0, 1.0), (0, 63)),
        ((-1.0, -1.0), (63, 0)),
        ((1.0, -1.0), (63, 63)),
        ((0.0, 0.0), (32, 32)),
        ((-0.001, 0.001), (31, 31)),
        ((0.5, 0.0), (32, 48)),
        ((0.0, 0.5), (16, 32)),
    ],
)
def test_row_0_is_plus_y_and_column_0_is_minus_x(
    xy: tuple[float, float], row_col: tuple[int, int]
) -> None:
    assert WORKSPACE.xy_to_row_col(*xy) == row_col


def test_points_outside_fall_into_the_nearest_border_cell() -> None:
    assert WORKSPACE.xy_to_row_col(-7.0, 0.0) == (32, 0)
    assert WORKSPACE.xy_to_row_col(9.0, 9.0, resolution=10) == (0, 9)


def test_centres_of_the_papers_10_by_10_grid() -> None:
    assert WORKSPACE.row_col_to_xy(0, 0, resolution=10) == pytest.approx((-0.9, 0.9))
    assert WORKSPACE.row_col_to_xy(9, 3, resolution=10) == pytest.approx((-0.3, -0.9))


@pytest.mark.parametrize("resolution", [None, 1, 10, 16, 33])
@pytest.mark.parametrize("half_length", [0.3, 1.0, 1.7])
def test_every_cell_contains_its_centre(half_length: float, resolution: int | None) -> None:
    workspace = Workspace(half_length)
    cells = resolution or workspace.image_size
    for row in range(cells):
        for col in range(cells):
            xy = workspace.row_col_to_xy(row, col, resolution)
            assert workspace.xy_to_row_col(*xy, resolution) == (row, col)


@pytest.mark.parametrize("resolution", [None, 7])
def test_all_centres_at_once_equal_one_by_one(resolution: int | None) -> None:
    centres = WORKSPACE.cell_centres(resolution)
    cells = resolution or 64
    assert centres.shape == (cells, cells, 2)
    for row, col in [(0, 0), (0, cells - 1), (3, 5), (cells - 1, 2)]:
        expected = WORKSPACE.row_col_to_xy(row, col, resolution)
        np.testing.assert_allclose(centres[row, col], expected, atol=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_a_point_lies_within_half_a_cell_of_its_cells_centre(seed: int) -> None:
    for x, y in np.random.default_rng(seed).uniform(-1.0, 1.0, (100, 2)):
        centre = WORKSPACE.row_col_to_xy(*WORKSPACE.xy_to_row_col(x, y))
        assert max(abs(centre[0] - x), abs(centre[1] - y)) <= 0.03125 / 2 + 1e-12
