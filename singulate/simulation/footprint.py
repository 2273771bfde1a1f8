"""What a block covers on the table."""

import itertools
import math
from functools import lru_cache

import cv2
import numpy as np
import numpy.typing as npt

from singulate.geometry import BlockPose
from singulate.geometry.rectangle import Polygon

CUBE_REACH = math.sqrt(3.0) / 2.0
"""No part of a cube is further from its centre than this share of its side."""

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


def _rotation(quaternion: tuple[float, float, float, float]) -> npt.NDArray[np.float64]:
    x, y, z, w = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
