"""Segments: what one picture can tell apart."""

import cv2
import numpy as np
import numpy.typing as npt


def label_segments(mask: npt.NDArray[np.bool_]) -> npt.NDArray[np.int32]:
    """Number the connected regions of a mask.

    Pixels belong together where they share an edge (4-connectivity): two blocks that meet at a
    corner alone can be told apart. A single block never falls to pieces under this rule, however it
    is turned: a corner of 90 degrees always opens towards one of the four neighbours, so even the
    pixel at its tip shares an edge with the next.

    Args:
        mask: Pixels that show objects, bool (H, W).

    Returns:
        int32 (H, W): 0 on the background, 1 to K on the K segments, numbered in the order in which
        reading the image row by row first meets them.

    Example:
        >>> label_segments(np.array([[True, False, True], [False, True, True]])).tolist()
        [[1, 0, 2], [0, 2, 2]]
    """
    left, top, width, height = cv2.boundingRect(mask.view(np.uint8))
    label_image = np.zeros(mask.shape, dtype=np.int32)
    if width > 0:
        part = np.s_[top : top + height, left : left + width]
        _, label_image[part] = connected_regions(mask[part])
    return label_image


def connected_regions(mask: npt.NDArray[np.bool_]) -> tuple[int, npt.NDArray[np.int32]]:
    """K and the label image of `label_segments`, faster where objects fill most of the mask.

    Args:
        mask: Pixels that show objects, bool (H, W), at least one pixel.
    """
    num_labels, label_image = cv2.connectedComponents(mask.view(np.uint8), connectivity=4)
    return num_labels - 1, np.asarray(label_image, np.int32)
