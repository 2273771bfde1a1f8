"""Pictures turned so that a push points up, and where points of the table lie in them."""

import numpy as np
import numpy.typing as npt

from singulate.agents.policy import FloatMap
from singulate.geometry import Direction

Pixels = npt.NDArray[np.float64]
"""Continuous (row, column) in a turned picture, (N, 2); whole numbers are pixel centres."""


def turn_each(images: FloatMap, directions: npt.NDArray[np.int64]) -> FloatMap:
    """Turn each picture by quarter turns until its push points up.

    Args:
        images: float32 (N, H, H).
        directions: The push's direction for each, int64 (N,).

    Returns:
        A copy, float32 (N, H, H).
    """
    turned = np.empty_like(images)
    for direction in Direction:
        rows = np.flatnonzero(directions == direction)
        turned[rows] = np.rot90(images[rows], k=direction, axes=(1, 2))
    return turned


def turn_all_ways(image: FloatMap) -> FloatMap:
    """A picture (H, H) turned for each direction, (4, H, H)."""
    return np.stack([np.rot90(image, k=direction) for direction in Direction])


def turn_back(maps: FloatMap) -> FloatMap:
    """The inverse of turning: one map for each direction, (4, H, H), as the table lies."""
    return np.stack([np.rot90(maps[direction], k=-direction) for direction in Direction])


def to_turned_pixels(
    starts: npt.NDArray[np.float64], directions: npt.NDArray[np.int64], size: int
) -> Pixels:
    """Where pushes start in the pictures that are turned for them.

    Args:
        starts: (x / l, y / l) of each push, (N, 2).
        directions: Its direction, int64 (N,).
        size: Pixels along each side, H.
    """
    x, y = starts[:, 0], starts[:, 1]
    turned_x = np.choose(directions, [x, -y, -x, y])
    turned_y = np.choose(directions, [y, x, -y, -x])
    rows = (1.0 - turned_y) * size / 2 - 0.5
    columns = (turned_x + 1.0) * size / 2 - 0.5
    return np.stack([rows, columns], axis=1)


def from_turned_pixel(
    row: float, column: float, direction: Direction, size: int
) -> tuple[float, float]:
    """The inverse of `to_turned_pixels` for one push: its start, (x / l, y / l)."""
    x, y = (column + 0.5) * 2 / size - 1.0, 1.0 - (row + 0.5) * 2 / size
    for _ in range(direction):
        x, y = y, -x
    return x, y
