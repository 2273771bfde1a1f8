"""Which part of a turned picture matters."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import BLOCK

_HALF_PUSHER = 2
"""Columns beside an object from which a push can still touch it [px]; the pusher is 2 px wide."""


@dataclass(frozen=True)
class Region:
    """A rectangle of pixels; its sides and its corner are multiples of `BLOCK`."""

    row: int
    column: int
    height: int
    width: int


def starts_that_reach(distance_map: FloatMap, push_px: float) -> Region:
    """Starts from which a push upwards may touch an object; everything where there is none.

    Args:
        distance_map: Turned so that the push points up, float32 (H, H), -1 inside objects.
        push_px: Length of a push [px].
    """
    size = len(distance_map)
    rows, columns = np.nonzero(distance_map < 0.0)
    if not len(rows):
        return Region(0, 0, size, size)
    row, bottom = int(rows.min()), min(int(rows.max() + push_px) + 2, size - 1)
    column = max(int(columns.min()) - _HALF_PUSHER, 0)
    right = min(int(columns.max()) + _HALF_PUSHER, size - 1)
    row, column = row - row % BLOCK, column - column % BLOCK
    height, width = bottom + 1 - row, right + 1 - column
    return Region(row, column, height + -height % BLOCK, width + -width % BLOCK)


def of_equal_size(regions: Sequence[Region], size: int) -> list[Region]:
    """The same regions, grown to the size of the largest and kept on a picture of `size` pixels."""
    height = max(region.height for region in regions)
    width = max(region.width for region in regions)
    return [
        replace(
            region,
            row=min(region.row, size - height),
            column=min(region.column, size - width),
            height=height,
            width=width,
        )
        for region in regions
    ]
