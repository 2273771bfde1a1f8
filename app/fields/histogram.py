"""Where pushes start: how often each cell of the table was chosen (paper, Fig. 6)."""

import numpy as np
import numpy.typing as npt

from singulate.geometry import Workspace

NUM_BINS = 32
GRID_SAMPLE = 2000
"""Starts that are looked at to find a grid."""


def start_histogram(
    starts: npt.NDArray[np.floating], workspace: Workspace, num_bins: int = NUM_BINS
) -> npt.NDArray[np.float32]:
    """Count start positions by cell.

    Args:
        starts: (N, 2) world x, y [m]; positions off the table are not counted.
        workspace: The table.
        num_bins: Cells along each side.

    Returns:
        Counts, float32 (num_bins, num_bins); row 0 is +y, column 0 is -x.
    """
    edge = workspace.half_length
    counts, _, _ = np.histogram2d(
        -starts[:, 1], starts[:, 0], bins=num_bins, range=[[-edge, edge], [-edge, edge]]
    )
    return np.asarray(counts, dtype=np.float32)


def fitting_bins(starts: npt.NDArray[np.floating], workspace: Workspace) -> int:
    """Cells along each side that suit some starts (N, 2) [m].

    Agents with a grid of starts (paper, section 5.4) get the cells of their grid; finer ones would
    show stripes of empty cells.
    """
    columns = np.unique(np.round(starts[-GRID_SAMPLE:, 0], 3))
    if not 2 <= len(columns) < NUM_BINS:
        return NUM_BINS
    return min(max(1, round(workspace.length / float(np.diff(columns).min()))), NUM_BINS)


def starts_between(
    starts: npt.NDArray[np.float32],
    steps: npt.NDArray[np.int64],
    first: int,
    last: int,
) -> npt.NDArray[np.float32]:
    """Rows of `starts` (N, 2) whose step, ascending in `steps` (N,), lies in [first, last]."""
    low, high = np.searchsorted(steps, [first, last + 1])
    return starts[low:high]
