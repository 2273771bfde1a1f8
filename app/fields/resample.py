"""Maps of different resolutions brought to the same one, without inventing values."""

import numpy as np
import numpy.typing as npt


def nearest(values: npt.NDArray[np.generic], resolution: int) -> npt.NDArray[np.generic]:
    """Repeat or drop cells so that a map has another resolution.

    Args:
        values: A map (H, W) or a picture (H, W, C).
        resolution: Cells along each side of the result.

    Returns:
        The value of the cell that each new cell's centre lies in, (resolution, resolution, ...).
    """
    rows = ((np.arange(resolution) + 0.5) * values.shape[0] / resolution).astype(np.intp)
    cols = ((np.arange(resolution) + 0.5) * values.shape[1] / resolution).astype(np.intp)
    resampled: npt.NDArray[np.generic] = values.take(cols, axis=1).take(rows, axis=0)
    return resampled


def nearest_stack(values: npt.NDArray[np.float32], resolution: int) -> npt.NDArray[np.float32]:
    """`nearest` for maps that lie on top of each other, float32 (N, H, W)."""
    rows = ((np.arange(resolution) + 0.5) * values.shape[1] / resolution).astype(np.intp)
    cols = ((np.arange(resolution) + 0.5) * values.shape[2] / resolution).astype(np.intp)
    resampled: npt.NDArray[np.float32] = values.take(cols, axis=2).take(rows, axis=1)
    return resampled
