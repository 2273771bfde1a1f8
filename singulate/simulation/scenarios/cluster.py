"""Clusters: blocks grown face to face into a random polyomino."""

import numpy as np
import numpy.typing as npt

from singulate.geometry import Block, Direction, Layout, Workspace
from singulate.geometry.rectangle import penetration
from singulate.simulation.scenarios.row import EDGE_MARGIN
from singulate.simulation.scenarios.scenario import SIDE_RANGE

_OVERLAP = 1e-6

Vector = npt.NDArray[np.float64]
"""A point or displacement on the table, shape (2,) [m]."""


def random_cluster(num_blocks: int, rng: np.random.Generator, workspace: Workspace) -> Layout:
    """Grow a cluster: each block joins a random face of a random earlier block, where it fits."""
    blocks = [Block(0.0, 0.0, float(rng.uniform(*SIDE_RANGE)))]
    while len(blocks) < num_blocks:
        host = blocks[rng.integers(len(blocks))]
        dx, dy = Direction(int(rng.integers(4))).vector
        side = float(rng.uniform(*SIDE_RANGE))
        gap = (host.side + side) / 2
        candidate = Block(host.x + dx * gap, host.y + dy * gap, side)
        if all(penetration(candidate.footprint, b.footprint) < _OVERLAP for b in blocks):
            blocks.append(candidate)
    low, high = _bounds(blocks)
    if (high - low).max() > workspace.length:
        return random_cluster(num_blocks, rng, workspace)
    shift = _place(low, high, rng, workspace)
    return tuple(Block(b.x + shift[0], b.y + shift[1], b.side) for b in blocks)


def _bounds(blocks: list[Block]) -> tuple[Vector, Vector]:
    corners = np.concatenate([block.footprint for block in blocks])
    return corners.min(axis=0), corners.max(axis=0)


def _place(low: Vector, high: Vector, rng: np.random.Generator, workspace: Workspace) -> Vector:
    room = workspace.half_length - (high - low) / 2
    reach = np.maximum(room - EDGE_MARGIN, room / 2)
    shift: Vector = rng.uniform(-reach, reach) - (low + high) / 2
    return shift
