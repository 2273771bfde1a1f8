"""How far the pusher can move before it may touch anything."""

import math

import numpy as np
import numpy.typing as npt

from singulate.geometry import Poses, Push
from singulate.geometry.rectangle import Polygon
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import SWEEP_MARGIN, block_footprint

Points = npt.NDArray[np.float64]


def free_length(poses: Poses, push: Push, pusher_side: float) -> float:
    """Length of a push's beginning on which no block comes within `SWEEP_MARGIN` [m].

    Blocks behind the pusher do not count: it moves away from them.

    Args:
        poses: The blocks at rest; fallen ones are in nobody's way.
        push: The push; its start is not blocked.
        pusher_side: Width of the pusher [m].

    Returns:
        Length, infinite where nothing stands in the way, however far the pusher goes.
    """
    half = pusher_side / 2 + SWEEP_MARGIN
    return min(
        (
            first - half
            for first, last in block_intervals(poses, push.start, push.direction, half)
            if last > 0.0
        ),
        default=math.inf,
    )


def block_intervals(
    poses: Poses, origin: tuple[float, float], direction: tuple[float, float], half_width: float
) -> list[tuple[float, float]]:
    """Where the blocks stand along a line.

    Args:
        poses: The blocks.
        origin: A point on the line [m].
        direction: Unit vector.
        half_width: Half the width of the strip around the line that is looked at [m].

    Returns:
        (First, last) [m] from the origin, along the direction, of each block's part in the strip;
        blocks that do not reach into the strip are left out.
    """
    along = np.asarray(direction)
    across = np.array([-along[1], along[0]])
    intervals = []
    for pose in poses:
        if is_fallen(pose):
            continue
        footprint = block_footprint(pose) - np.asarray(origin)
        inside = _cut(_cut(footprint, across, half_width), -across, half_width)
        if len(inside):
            reach = inside @ along
            intervals.append((float(reach.min()), float(reach.max())))
    return intervals


def _cut(polygon: Polygon, normal: Points, limit: float) -> Points:
    """The part of a convex polygon on which ``normal . x <= limit``, shape (K, 2)."""
    excess = polygon @ normal - limit
    corners = []
    for i in range(len(polygon)):
        a, b = excess[i - 1], excess[i]
        if (a <= 0.0) != (b <= 0.0):
            corners.append(polygon[i - 1] + (polygon[i] - polygon[i - 1]) * (a / (a - b)))
        if b <= 0.0:
            corners.append(polygon[i])
    return np.array(corners).reshape(-1, 2)
