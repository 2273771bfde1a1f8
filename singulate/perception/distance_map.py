"""The distance map: how far every pixel is from the closest object (paper, section 3.1)."""

import math

import cv2
import numpy as np
import numpy.typing as npt

INSIDE = -1.0
"""Value of the pixels on an object."""


def distance_map(mask: npt.NDArray[np.bool_]) -> npt.NDArray[np.float32]:
    """Distance of every pixel's centre to the centre of the closest object pixel.

    The last bit of OpenCV's distances depends on where in memory they lie. Their squares are whole
    numbers, so rounding those and taking the root again gives the same bits in every process.

    Args:
        mask: Pixels that show objects, bool (H, W).

    Returns:
        float32 (H, W) [px]: exact Euclidean distances, so at least 1 outside objects, and -1 inside
        them. Without any object, the image's diagonal everywhere: farther than any true distance.

    Example:
        >>> distance_map(np.array([[True, False, False, False]])).tolist()
        [[-1.0, 1.0, 2.0, 3.0]]
    """
    if not mask.any():
        return np.full(mask.shape, math.hypot(*mask.shape), dtype=np.float32)
    background = (~mask).view(np.uint8)
    distances = cv2.distanceTransform(background, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    exact: npt.NDArray[np.float32] = np.sqrt(np.rint(distances * distances))
    exact[mask] = INSIDE
    return exact
