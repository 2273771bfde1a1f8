"""Where a Gaussian policy starts its pushes (paper, Fig. 6), without sampling."""

import math

import numpy as np
import numpy.typing as npt


def gaussian_start_density(
    mean: npt.NDArray[np.float64], deviation: npt.NDArray[np.float64], num_cells: int
) -> npt.NDArray[np.float32]:
    """Probability of each cell for a start that is Gaussian and then clipped to the square.

    Args:
        mean: Mean of (x / l, y / l), shape (2,).
        deviation: Standard deviations, shape (2,), above 0.
        num_cells: Cells along each side.

    Returns:
        float32 (num_cells, num_cells), row 0 at +y, summing to 1; what the clipping moves onto the
        border counts in the border cells.
    """
    columns = _interval_masses(mean[0], deviation[0], num_cells)
    rows = _interval_masses(mean[1], deviation[1], num_cells)[::-1]
    return np.outer(rows, columns).astype(np.float32)


def _interval_masses(mean: float, deviation: float, num_cells: int) -> npt.NDArray[np.float64]:
    edges = np.linspace(-1.0, 1.0, num_cells + 1)[1:-1]
    scaled = (edges - mean) / (deviation * math.sqrt(2.0))
    below = np.array([0.5 * math.erfc(-value) for value in scaled])
    return np.diff(np.concatenate([[0.0], below, [1.0]]))
