"""How a block rests in Bullet: a little inside the table, and leaning by a hair."""

import math

from singulate.geometry import BlockPose
from singulate.simulation.boxes import Quaternion, Vector3

_INSET = 5e-6
"""Blocks are solid from this far behind their faces on [m]. Without it, whether blocks that stand
face to face rub against each other would hang on how their places are rounded: in 500 pushes on
two of them, ends differed by 1.8 mm in the median once the approach was left out, and with it, or
with any gap, by 0.4 mm."""

_SINK = 1.36e-5
"""How deep the centre of a solid block sinks, whatever its side [m]. Boxes that merely touch have
no contact in Bullet: a block put exactly on the table would fall freely for one step, 1 mm deep."""
_LEAN = 4.5e-6
"""How much deeper one of its sides sinks than the centre [m], because Bullet's solver serves the
corners one after the other. A block that is put up without it leans over in some 40 steps."""
_LAID_OUT = 1e-4
"""A block this close to the height of its layout stands on the table [m]."""


def solid_half_extents(side: float) -> Vector3:
    """Half of the sides of the box that Bullet holds for a block [m]."""
    half = side / 2 - _INSET
    return half, half, half


def resting_place(pose: BlockPose) -> tuple[Vector3, Quaternion]:
    """Where Bullet holds a block.

    Args:
        pose: As Bullet has left it, or as a layout says, just upright and on the table.

    Returns:
        Position [m] and orientation; of a block from a layout those in which it stays where it is.
    """
    (x, y, z), (qx, qy, sin_yaw, cos_yaw), side = pose
    if qx != 0.0 or qy != 0.0 or abs(z - side / 2) > _LAID_OUT:
        return pose.position, pose.quaternion
    lean = -_LEAN / side  # half of the angle, about the block's own y
    sin, cos = math.sin(lean), math.cos(lean)
    turn = (-sin_yaw * sin, cos_yaw * sin, sin_yaw * cos, cos_yaw * cos)
    return (x, y, side / 2 - _INSET - _SINK), turn
