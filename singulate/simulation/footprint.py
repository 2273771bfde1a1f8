"""What a push covers on the table, and which blocks stand there."""

import itertools
from functools import lru_cache

import cv2
import numpy as np
import numpy.typing as npt

from singulate.geometry import BlockPose, Push
from singulate.geometry.rectangle import Polygon, rectangle

SWEEP_MARGIN = 0.01
"""A block this close to the swept strip counts as touched, since contact has a skin [m]."""

_CORNERS = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))  # (8, 3)


@lru_cache(maxsize=1024)
def block_footprint(pose: BlockPose) -> Polygon:
    """Outline of a block seen from above, also of a tipped one, shape (K, 2) [m], read-only.

    Each push asks for it a few times.
    """
    corners = _CORNERS * pose.side @ _rotation(pose.quaternion).T  # (8, 3)
    outline = cv2.convexHull(corners[:, :2].astype(np.float32))[:, 0, :]
    if cv2.contourArea(outline, oriented=True) < 0.0:
        outline = outline[::-1]
    footprint: Polygon = outline.astype(np.float64) + np.asarray(pose.position[:2])
    footprint.flags.writeable = False
    return footprint


def pusher_footprint(push: Push, pusher_side: float) -> Polygon:
    """Square on which the pusher is lowered, shape (4, 2) [m]."""
    return rectangle(push.start, (pusher_side / 2, pusher_side / 2), push.yaw)


def swept_footprint(push: Push, pusher_side: float) -> Polygon:
    """Strip that the pusher covers from start to end, shape (4, 2) [m]."""
    middle = (
        (push.start[0] + push.end[0]) / 2,
        (push.start[1] + push.end[1]) / 2,
    )
    half = pusher_side / 2
    return rectangle(middle, (push.length / 2 + half, half), push.yaw)


def _rotation(quaternion: tuple[float, float, float, float]) -> npt.NDArray[np.float64]:
    x, y, z, w = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
