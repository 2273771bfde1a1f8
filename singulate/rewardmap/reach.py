"""Which starts' pushes can move a block: the footprint tests of the scene, for whole grids."""

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


def blocked_starts(
    poses: Poses, workspace: Workspace, resolution: int, pusher_side: float
) -> BoolMap:
    """Cells at whose centre the pusher would surely land on a block, (H, W)."""
    centres = workspace.cell_centres(resolution)
    half = np.array([pusher_side / 2, pusher_side / 2])
    return _depth(poses, centres, half) > _UNDECIDED


def reaching_starts(
    poses: Poses, workspace: Workspace, resolution: int, pusher_side: float
) -> BoolMap:
    """Cells from whose centre a push may meet a block, by direction, (4, H, W)."""
    centres = workspace.cell_centres(resolution)
    reaching = np.zeros((len(Direction), resolution, resolution), dtype=np.bool_)
    half = pusher_side / 2 + SWEEP_MARGIN
    for direction in Direction:
        along = np.array(direction.vector) * (workspace.push_length + half) / 2
        half_extents = np.maximum(np.abs(along), half)
        reaching[direction] = _depth(poses, centres + along, half_extents) > -_UNDECIDED
    return reaching


def _depth(
    poses: Poses, centres: npt.NDArray[np.float64], half: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """Deepest overlap of an upright box around each centre with any block, (H, W) [m]."""
    depth = np.full(centres.shape[:-1], -np.inf)
    for pose in poses:
        if not is_fallen(pose):
            np.maximum(depth, _box_penetration(centres, half, block_footprint(pose)), out=depth)
    return depth


def _box_penetration(
    centres: npt.NDArray[np.float64], half: npt.NDArray[np.float64], polygon: Polygon
) -> npt.NDArray[np.float64]:
    """`geometry.rectangle.penetration` of a box at each centre with one polygon, (H, W) [m]."""
    below = centres + half - polygon.min(axis=0)  # (H, W, 2) along +x and +y
    above = polygon.max(axis=0) - (centres - half)
    edges = np.roll(polygon, -1, axis=0) - polygon  # (K, 2)
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    reach = (normals * polygon).sum(axis=1)  # (K,)
    nearest = centres @ normals.T - np.abs(normals) @ half  # (H, W, K)
    depth: npt.NDArray[np.float64] = np.minimum(below, above).min(axis=-1)
    np.minimum(depth, (reach - nearest).min(axis=-1), out=depth)
    return depth
