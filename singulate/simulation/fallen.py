"""Blocks that have left the table."""

from singulate.geometry import BlockPose
from singulate.simulation.boxes import UPRIGHT

FLOOR_Z = -0.75
"""Height of the floor under the table [m]; a block that fell off lies there."""

_FALLEN_Z = -0.2
"""A block whose centre is below this has left the table [m]."""


def is_fallen(pose: BlockPose) -> bool:
    """Whether a block has left the table."""
    return pose.position[2] < _FALLEN_Z


def on_the_floor(pose: BlockPose) -> BlockPose:
    """Where a block that fell off is taken to lie: under the point at which it left."""
    x, y, _ = pose.position
    return BlockPose((x, y, FLOOR_Z + pose.side / 2), UPRIGHT, pose.side)
