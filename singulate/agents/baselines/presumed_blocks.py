"""Blocks that a blob may consist of: squares fitted into the mask from its corners."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

BoolMap = npt.NDArray[np.bool_]

MAX_SIDE_PX = 8
"""The largest block of the scenes, 0.25 m, in pixels of 31.25 mm (section 4)."""
MIN_SIDE_PX = 3
"""Smaller squares are the ragged edges of blocks that are there already."""


class PresumedBlock(NamedTuple):
    """A square in the image: centre (row, column) and side [px]."""

    row: float
    col: float
    side: int


def presume_blocks(mask: BoolMap) -> list[PresumedBlock]:
    """Divide the objects of a mask into upright squares.

    Every part of a row of squares has a free corner at its left end. So the square that fits
    exactly there is taken for a block, is removed, and the rest is looked at again.

    Args:
        mask: Pixels that show objects, bool (H, W).
    """
    rest = mask.copy()
    blocks = []
    while rest.any():
        row, col = _first_corner(rest)
        side = _largest_square(rest, row, col)
        if side >= MIN_SIDE_PX:
            middle = (side - 1) / 2
            blocks.append(PresumedBlock(row + middle, col + middle, side))
        rest[row : row + side, col : col + side] = False
    return blocks


def _first_corner(mask: BoolMap) -> tuple[int, int]:
    """(row, column) of the topmost pixel in the leftmost column that has any."""
    col = int(np.argmax(mask.any(axis=0)))
    return int(np.argmax(mask[:, col])), col


def _largest_square(mask: BoolMap, row: int, col: int) -> int:
    """Side of the largest square of object pixels whose upper left pixel is given [px]."""
    side = 1
    while side < MAX_SIDE_PX and _is_filled(mask, row, col, side + 1):
        side += 1
    return side


def _is_filled(mask: BoolMap, row: int, col: int, side: int) -> bool:
    window = mask[row : row + side, col : col + side]
    return window.shape == (side, side) and bool(window.all())
