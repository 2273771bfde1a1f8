"""Where a block can stand: inside the workspace and on no other block."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from singulate.geometry import Block, Workspace
from singulate.geometry.rectangle import Polygon, penetration

_CONTACT = 1e-6
"""Gap that is left between blocks in contact, so that rounding does not make them overlap [m]."""
_MAX_SLIDES = 8
_HALVINGS = 20
_CELLS = 41
"""Places along each side of the table that are tried for a new block."""

Vector = npt.NDArray[np.float64]
"""A displacement on the table, shape (2,) [m]."""


def nearest_free(
    wanted: Block, start: Block, others: Sequence[Polygon], workspace: Workspace
) -> Block:
    """Where a block comes to stand that somebody moves by hand.

    It slides along what it meets, as a block does that is dragged past others; where that leads
    nowhere, it stops at the last free place on the straight way.

    Args:
        wanted: Where it should go.
        start: Where it stands, freely; of the same side.
        others: Footprints of the other blocks.
        workspace: Its footprint stays inside.
    """
    block = _inside(wanted, workspace)
    for _ in range(_MAX_SLIDES):
        escape = _escape(block.footprint, others)
        if escape is None:
            return block
        block = _inside(
            replace(block, x=block.x + float(escape[0]), y=block.y + float(escape[1])), workspace
        )
    return _last_free(start, _inside(wanted, workspace), others)


def free_place(
    side: float, others: Sequence[Polygon], workspace: Workspace, gap: float
) -> Block | None:
    """The place nearest to the table's centre where an upright block keeps a gap to all others.

    Args:
        side: Of the block [m].
        others: Footprints of the other blocks.
        workspace: Its footprint stays inside.
        gap: Room around it [m].

    Returns:
        None where there is no such place.
    """
    reach = workspace.half_length - side / 2
    ticks = np.linspace(-reach, reach, _CELLS).tolist()
    places = sorted(((x, y) for x in ticks for y in ticks), key=lambda place: math.hypot(*place))
    for x, y in places:
        room = Block(x, y, side + 2 * gap).footprint
        if all(penetration(room, other) <= 0.0 for other in others):
            return Block(x, y, side)
    return None


def _inside(block: Block, workspace: Workspace) -> Block:
    reach = np.abs(block.footprint - (block.x, block.y)).max(axis=0)
    room = np.maximum(workspace.half_length - reach, 0.0)
    x, y = np.clip((block.x, block.y), -room, room)
    return replace(block, x=float(x), y=float(y))


def _escape(footprint: Polygon, others: Sequence[Polygon]) -> Vector | None:
    """The shortest way out of the block that it overlaps most; None where it overlaps none."""
    deepest = max(others, key=lambda other: penetration(footprint, other), default=None)
    if deepest is None or penetration(footprint, deepest) <= 0.0:
        return None
    ways = [
        normal * (depth + _CONTACT)
        for polygon, sign in ((deepest, 1.0), (footprint, -1.0))
        for normal, depth in _ways_out(footprint, deepest, polygon, sign)
    ]
    return min(ways, key=lambda way: float(np.linalg.norm(way)))


def _ways_out(
    mover: Polygon, other: Polygon, edges_of: Polygon, sign: float
) -> list[tuple[Vector, float]]:
    """For each edge, in which direction and how far `mover` has to go to clear `other` [m]."""
    edges = np.roll(edges_of, -1, axis=0) - edges_of
    normals = sign * np.stack([edges[:, 1], -edges[:, 0]], axis=1)  # (K, 2)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    depths = (normals @ other.T).max(axis=1) - (normals @ mover.T).min(axis=1)  # (K,)
    return list(zip(normals, depths.tolist(), strict=True))


def _last_free(start: Block, end: Block, others: Sequence[Polygon]) -> Block:
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        is_free = _escape(_between(start, end, middle).footprint, others) is None
        low, high = (middle, high) if is_free else (low, middle)
    return _between(start, end, low)


def _between(start: Block, end: Block, share: float) -> Block:
    return replace(
        start,
        x=start.x + share * (end.x - start.x),
        y=start.y + share * (end.y - start.y),
        yaw=start.yaw + share * (end.yaw - start.yaw),
    )
