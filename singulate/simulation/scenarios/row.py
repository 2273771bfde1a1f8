"""Rows of blocks that touch face to face: the paper's scenes (Fig. 1, sections 5.2 and 5.4)."""

import numpy as np

from singulate.geometry import Block, Layout, Workspace
from singulate.simulation.scenarios.scenario import FIXED_SIDE, SIDE_RANGE

EDGE_MARGIN = 0.25
"""Room kept between a row and the table's edge, where the row is short enough [m]."""


def fixed_row(num_blocks: int, rng: np.random.Generator, workspace: Workspace) -> Layout:
    """A row of equal blocks along x, centred at the origin; nothing is drawn."""
    return _row([FIXED_SIDE] * num_blocks, (0.0, 0.0), along_x=True)


def random_row(num_blocks: int, rng: np.random.Generator, workspace: Workspace) -> Layout:
    """A row of blocks of varying sides at a random place, along x or y."""
    sides = rng.uniform(*SIDE_RANGE, num_blocks).tolist()
    along_x = bool(rng.integers(2))
    along = _offset(rng, workspace.half_length - sum(sides) / 2)
    across = _offset(rng, workspace.half_length - max(sides) / 2)
    return _row(sides, (along, across) if along_x else (across, along), along_x)


def _offset(rng: np.random.Generator, room: float) -> float:
    reach = max(room - EDGE_MARGIN, room / 2)
    return float(rng.uniform(-reach, reach))


def _row(sides: list[float], centre: tuple[float, float], along_x: bool) -> Layout:
    position = -sum(sides) / 2
    blocks = []
    for side in sides:
        offset = position + side / 2
        position += side
        x, y = (offset, 0.0) if along_x else (0.0, offset)
        blocks.append(Block(centre[0] + x, centre[1] + y, side))
    return tuple(blocks)
