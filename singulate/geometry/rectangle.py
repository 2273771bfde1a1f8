"""Oriented rectangles on the table: corners, overlap and distance."""

import math

import numpy as np
import numpy.typing as npt

Polygon = npt.NDArray[np.float64]
"""Corners of a convex polygon in order, shape (K, 2) [m]."""


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
    return min(_overlap_on_normals(a, b), _overlap_on_normals(b, a))


def _overlap_on_normals(a: Polygon, b: Polygon) -> float:
    edges = np.roll(a, -1, axis=0) - a
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1)  # (K, 2), outward
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    reach = (normals * a).sum(axis=1)  # (K,) support of a along its own normals
    nearest = (normals @ b.T).min(axis=1)  # (K,)
    return float((reach - nearest).min())


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
