"""The mask in an observation of either kind."""

import numpy as np
import numpy.typing as npt

from singulate.agents.policy import FloatMap


def mask_of(observation: FloatMap, kind: str) -> npt.NDArray[np.bool_]:
    """Pixels that show objects, bool (H, W).

    Args:
        observation: float32 (H, W).
        kind: ``distance_map``, where objects are -1 (section 3.2.1), or ``mask``, where they are 1.
    """
    image = np.asarray(observation)
    return image < 0.0 if kind == "distance_map" else image > 0.5


def object_points(mask: npt.NDArray[np.bool_], metres_per_pixel: float) -> npt.NDArray[np.float64]:
    """Centres of the pixels that show objects, (K, 2) [m]; row 0 is +y, column 0 is -x."""
    rows, cols = np.nonzero(mask)
    height, width = mask.shape
    x = (cols + 0.5 - width / 2) * metres_per_pixel
    y = (height / 2 - rows - 0.5) * metres_per_pixel
    return np.stack([x, y], axis=1)


def boxes_with_points(
    centres: npt.NDArray[np.float64],
    halves: npt.NDArray[np.float64],
    points: npt.NDArray[np.float64],
) -> npt.NDArray[np.bool_]:
    """Which upright boxes hold a point, (N,).

    Args:
        centres: (N, 2) [m].
        halves: Half their sizes, (N, 2) [m].
        points: (K, 2) [m].
    """
    inside: npt.NDArray[np.bool_] = np.abs(points - centres[:, None]) <= halves[:, None]
    covered: npt.NDArray[np.bool_] = np.any(np.all(inside, axis=2), axis=1)  # of (N, K, 2)
    return covered
