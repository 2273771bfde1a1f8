import numpy as np

from app.fields.histogram import NUM_BINS, fitting_bins, start_histogram, starts_between
from singulate.geometry import Workspace


def test_a_start_lands_in_the_cell_that_the_workspace_says():
    workspace = Workspace()
    for x, y in [(0.9, 0.9), (-0.9, 0.2), (0.05, -0.95), (0.0, 0.0)]:
        counts = start_histogram(np.array([[x, y]]), workspace, 10)
        row, col = np.argwhere(counts)[0]
        centre = workspace.row_col_to_xy(row, col, 10)
        assert max(abs(centre[0] - x), abs(centre[1] - y)) <= 0.1 + 1e-9


def test_starts_off_the_table_are_not_counted():
    starts = np.array([[0.0, 0.0], [1.5, 0.0], [0.0, -7.0]])
    assert start_histogram(starts, Workspace(), 4).sum() == 1.0


def test_no_starts_give_an_empty_histogram():
    assert start_histogram(np.zeros((0, 2)), Workspace(), 4).tolist() == [[0.0] * 4] * 4


def test_a_window_holds_its_two_ends():
    starts = np.arange(10, dtype=np.float32).reshape(5, 2)
    steps = np.array([10, 20, 30, 40, 50])
    assert starts_between(starts, steps, 20, 40)[:, 0].tolist() == [2.0, 4.0, 6.0]
    assert len(starts_between(starts, steps, 51, 99)) == 0


def test_starts_on_a_grid_get_the_cells_of_the_grid():
    along = (np.arange(10) + 0.5) * 0.2 - 1.0
    grid = np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 2).astype(np.float32)
    workspace = Workspace()
    assert fitting_bins(grid, workspace) == 10
    assert (start_histogram(grid, workspace, 10) == 1.0).all()
    assert fitting_bins(grid[::3], workspace) == 10


def test_starts_anywhere_get_fine_cells():
    starts = np.random.default_rng(0).uniform(-1.0, 1.0, (500, 2))
    assert fitting_bins(starts, Workspace()) == NUM_BINS
    assert fitting_bins(np.zeros((0, 2)), Workspace()) == NUM_BINS
    assert fitting_bins(np.zeros((5, 2)), Workspace()) == NUM_BINS
