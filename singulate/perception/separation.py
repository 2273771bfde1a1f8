"""Separations: the gaps between segments, measured in the image."""

import cv2
import numpy as np
import numpy.typing as npt

Mask = npt.NDArray[np.uint8]
"""1 on a segment, 0 elsewhere."""


def segment_separations(
    label_image: npt.NDArray[np.integer], metres_per_pixel: float
) -> npt.NDArray[np.float64]:
    """Distance d_ij of every pair of segments, edge to edge (paper, Eq. 1).

    It is the smallest distance between two pixel centres, less the half pixel on either side that
    still belongs to the objects: k background pixels between two straight edges that face each
    other give k pixels; segments whose pixels share an edge give 0.

    Args:
        label_image: Integers (H, W): 0 on the background, another, positive number on each segment.
        metres_per_pixel: Side of a pixel on the table [m].

    Returns:
        float64 (K * (K - 1) / 2,) [m], for the pairs (1, 2), (1, 3) ... (1, K), (2, 3) ... of the K
        segments in the order of their numbers.

    Example:
        >>> segment_separations(np.array([[1, 0, 0, 2, 0, 3]]), metres_per_pixel=0.5).tolist()
        [1.0, 2.0, 0.5]
    """
    if label_image.max(initial=0) < 2:
        return np.empty(0)  # most pictures show a single segment
    return mask_separations(_segment_masks(label_image), metres_per_pixel)


def mask_separations(masks: list[Mask], metres_per_pixel: float) -> npt.NDArray[np.float64]:
    """`segment_separations` from the mask of each segment, all in the same window."""
    squared = [
        distance for i, mask in enumerate(masks) for distance in _squared(mask, masks[i + 1 :])
    ]
    return (np.sqrt(np.array(squared, dtype=np.float64)) - 1.0) * metres_per_pixel


def _segment_masks(label_image: npt.NDArray[np.integer]) -> list[Mask]:
    """Each segment in the smallest window that holds them all."""
    left, top, width, height = cv2.boundingRect((label_image > 0).view(np.uint8))
    part = label_image[top : top + height, left : left + width]
    numbers = np.flatnonzero(np.bincount(part.ravel())).tolist()
    return [(part == number).view(np.uint8) for number in numbers if number > 0]


def _squared(mask: Mask, others: list[Mask]) -> list[int]:
    """Smallest squared distance from a segment's pixels to those of each other one [px^2]."""
    if not others:
        return []
    distances = cv2.distanceTransform(1 - mask, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    return [round(cv2.minMaxLoc(distances, other)[0] ** 2) for other in others]
