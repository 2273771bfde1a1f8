"""Where a Gaussian policy starts its pushes (paper, Fig. 6), without sampling."""

import math

import numpy as np
import numpy.typing as npt

FloatVector = npt.NDArray[np.float64]


def gaussian_start_density(
    mean: FloatVector, deviation: FloatVector, num_cells: int
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
    return _density(mean, deviation, _inner_edges(num_cells))


def squashed_start_density(
    mean: FloatVector, deviation: FloatVector, num_cells: int
) -> npt.NDArray[np.float32]:
    """The same for a start whose (x / l, y / l) is tanh of a Gaussian; mean and deviation are its.

    tanh rises, so that a start lies in a cell where the Gaussian lies between atanh of its edges.
    """
    return _density(mean, deviation, np.arctanh(_inner_edges(num_cells)))


def _inner_edges(num_cells: int) -> FloatVector:
    return np.linspace(-1.0, 1.0, num_cells + 1)[1:-1]


def _density(
    mean: FloatVector, deviation: FloatVector, edges: FloatVector
) -> npt.NDArray[np.float32]:
    columns = _interval_masses(mean[0], deviation[0], edges)
    rows = _interval_masses(mean[1], deviation[1], edges)[::-1]
    return np.outer(rows, columns).astype(np.float32)


def _interval_masses(mean: float, deviation: float, edges: FloatVector) -> FloatVector:
    """Mass before, between and behind edges."""
    scaled = (edges - mean) / (deviation * math.sqrt(2.0))
    below = np.array([0.5 * math.erfc(-value) for value in scaled])
    return np.diff(np.concatenate([[0.0], below, [1.0]]))
