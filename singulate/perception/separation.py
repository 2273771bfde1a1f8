"""Separations: the gaps between segments, measured in the image."""

import itertools

import numpy as np
import numpy.typing as npt

IntArray = npt.NDArray[np.int32]


def segment_separations(
    label_image: npt.NDArray[np.integer], metres_per_pixel: float
) -> npt.NDArray[np.float64]:
    """Distance d_ij of every pair of segments, edge to edge (paper, Eq. 1).

    It is the smallest distance between two pixel centres, less the half pixel on either side that
    still belongs to the objects: k background pixels between two straight edges that face each
    other give k pixels; segments whose pixels share an edge give 0.

    Args:
        label_image: Integers (H, W): 0 on the background, another number on each segment.
        metres_per_pixel: Side of a pixel on the table [m].

    Returns:
        float64 (K * (K - 1) / 2,) [m], for the pairs (1, 2), (1, 3) ... (1, K), (2, 3) ... of the K
        segments in the order of their numbers.

    Example:
        >>> segment_separations(np.array([[1, 0, 0, 2, 0, 3]]), metres_per_pixel=0.5).tolist()
        [1.0, 2.0, 0.5]
    """
    highest = int(label_image.max(initial=0))
    if not np.any((label_image > 0) & (label_image < highest)):
        return np.empty(0)  # most pictures show a single segment
    row_col, first = _border_pixels(label_image)
    squared = [
        _squared_distances(row_col[:, begin:end], row_col[:, end:], first[i + 1 :] - end)
        for i, (begin, end) in enumerate(itertools.pairwise(first.tolist()))
    ]
    return (np.sqrt(np.concatenate(squared), dtype=np.float64) - 1.0) * metres_per_pixel


def _border_pixels(label_image: npt.NDArray[np.integer]) -> tuple[IntArray, npt.NDArray[np.intp]]:
    """Segment pixels with a neighbour outside their segment, sorted by segment.

    The pair of pixels that is closest between two segments always lies on their borders: from a
    pixel with four neighbours in its own segment, one step leads closer to the other segment.

    Returns:
        (row, column) of each (2, P), and the index at which each segment's begin (K,).
    """
    height, width = label_image.shape
    padded = np.zeros((height + 2, width + 2), dtype=np.int32)
    padded[1:-1, 1:-1] = label_image
    flat, step = padded.ravel(), width + 2
    at = np.flatnonzero(flat)
    labels = flat[at]
    is_border = flat[at - 1] != labels
    for neighbour in (1, -step, step):
        is_border |= flat[at + neighbour] != labels
    at, labels = at[is_border], labels[is_border]
    order = np.argsort(labels, kind="stable")
    at, labels = at[order], labels[order]
    row_col = np.empty((2, at.size), dtype=np.int32)
    np.divmod(at, step, out=(row_col[0], row_col[1]), casting="unsafe")
    first = np.flatnonzero(np.concatenate(([True], labels[1:] != labels[:-1])))
    return row_col, first


def _squared_distances(
    pixels: IntArray, others: IntArray, first_of_other: npt.NDArray[np.intp]
) -> IntArray:
    """Smallest squared distance [px^2] from a segment to each of the segments after it.

    Args:
        pixels: (row, column) of the one segment's border, (2, P).
        others: (row, column) of the borders of all later segments, one after another, (2, Q).
        first_of_other: Index into `others` at which each of the L later segments begins, (L,).

    Returns:
        (L,)
    """
    rows = pixels[0, :, None] - others[0]
    cols = pixels[1, :, None] - others[1]
    closest = (rows * rows + cols * cols).min(axis=0)
    return np.minimum.reduceat(closest, first_of_other)
