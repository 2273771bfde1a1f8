"""Which starts' pushes can move a block: the footprint tests of the scene, for whole grids."""

import math

import numpy as np
import numpy.typing as npt

from singulate.geometry import Direction, Poses, Workspace
from singulate.geometry.rectangle import Polygon
from singulate.simulation.approach import SWEEP_MARGIN
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import block_footprint

_UNDECIDED = 1e-6
"""Footprints that come this close to touching are left to the scene's own test [m]."""

BoolMap = npt.NDArray[np.bool_]
FloatGrid = npt.NDArray[np.float64]
Axis = npt.NDArray[np.float64]
"""Places of the columns or of the rows, (W,) or (H,) [m]."""


def blocked_starts(
    poses: Poses, workspace: Workspace, resolution: int, pusher_side: float
) -> BoolMap:
    """Cells at whose centre the pusher would surely land on a block, (H, W)."""
    x, y = workspace.cell_axes(resolution)
    half = pusher_side / 2
    return _depth(poses, x, y, (half, half)) > _UNDECIDED


def reaching_starts(
    poses: Poses, workspace: Workspace, resolution: int, pusher_side: float
) -> BoolMap:
    """Cells from whose centre a push may meet a block, by direction, (4, H, W)."""
    x, y = workspace.cell_axes(resolution)
    reaching = np.zeros((len(Direction), resolution, resolution), dtype=np.bool_)
    half = pusher_side / 2 + SWEEP_MARGIN
    for direction in Direction:
        dx, dy = (each * (workspace.push_length + half) / 2 for each in direction.vector)
        half_extents = (max(abs(dx), half), max(abs(dy), half))
        reaching[direction] = _depth(poses, x + dx, y + dy, half_extents) > -_UNDECIDED
    return reaching


def _depth(poses: Poses, x: Axis, y: Axis, half: tuple[float, float]) -> FloatGrid:
    """Deepest overlap of an upright box around each centre with any block, (H, W) [m]."""
    depth = np.full((y.size, x.size), -np.inf)
    for pose in poses:
        if not is_fallen(pose):
            np.maximum(depth, _box_penetration(x, y, half, block_footprint(pose)), out=depth)
    return depth


def _box_penetration(x: Axis, y: Axis, half: tuple[float, float], polygon: Polygon) -> FloatGrid:
    """`geometry.rectangle.penetration` of a box at each centre with one polygon, (H, W) [m]."""
    (left, low), (right, high) = polygon.min(axis=0), polygon.max(axis=0)
    along_x = np.minimum(x + half[0] - left, right - (x - half[0]))  # (W,)
    along_y = np.minimum(y + half[1] - low, high - (y - half[1]))  # (H,)
    depth: FloatGrid = np.minimum.outer(along_y, along_x)
    x0, y0 = polygon[-1]
    for x1, y1 in polygon:
        length = math.hypot(x1 - x0, y1 - y0)
        nx, ny = (y1 - y0) / length, (x0 - x1) / length  # outward
        reach = nx * x1 + ny * y1 + abs(nx) * half[0] + abs(ny) * half[1]
        np.minimum(depth, np.subtract.outer(reach - ny * y, nx * x), out=depth)
        x0, y0 = x1, y1
    return depth
