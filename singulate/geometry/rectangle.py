"""Oriented rectangles on the table: corners, overlap and distance."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

Polygon = npt.NDArray[np.float64]
"""Corners of a convex polygon in order, shape (K, 2) [m]."""

Corner = tuple[float, float]
"""(x, y) [m]."""


def rectangle(
    centre: tuple[float, float], half_extents: tuple[float, float], yaw: float
) -> Polygon:
    """Corners of an oriented rectangle, counter-clockwise, shape (4, 2) [m]."""
    cos, sin = math.cos(yaw), math.sin(yaw)
    hx, hy = half_extents
    local = np.array([[hx, hy], [-hx, hy], [-hx, -hy], [hx, -hy]])
    rotation = np.array([[cos, sin], [-sin, cos]])
    corners: Polygon = local @ rotation + np.asarray(centre)
    return corners


def penetration(a: Polygon, b: Polygon) -> float:
    """Depth by which two convex polygons overlap [m]; 0 or negative where they do not.

    The separating-axis test: the smallest overlap of the two projections over all edge normals.
    """
    corners, others = a.tolist(), b.tolist()
    return min(_overlap_on_normals(corners, others), _overlap_on_normals(others, corners))


def _overlap_on_normals(a: Sequence[Corner], b: Sequence[Corner]) -> float:
    # A few corners are sooner looked at one by one than handed to NumPy.
    overlap = math.inf
    x0, y0 = a[-1]
    for x1, y1 in a:
        nx, ny = y1 - y0, x0 - x1  # outward
        reach = nx * x1 + ny * y1
        nearest = min([nx * x + ny * y for x, y in b])
        overlap = min(overlap, (reach - nearest) / math.hypot(nx, ny))
        x0, y0 = x1, y1
    return overlap


def distance(a: Polygon, b: Polygon) -> float:
    """Smallest distance between two convex polygons [m]; 0 where they overlap."""
    if penetration(a, b) > 0.0:
        return 0.0
    return min(_corner_to_edge(a, b), _corner_to_edge(b, a))


def _corner_to_edge(corners: Polygon, polygon: Polygon) -> float:
    start = polygon
    edge = np.roll(polygon, -1, axis=0) - polygon  # (K, 2)
    offset = corners[:, None, :] - start[None, :, :]  # (C, K, 2)
    along = (offset * edge).sum(axis=-1) / (edge * edge).sum(axis=-1)
    nearest = start + np.clip(along, 0.0, 1.0)[..., None] * edge
    return float(np.linalg.norm(corners[:, None, :] - nearest, axis=-1).min())
