"""How the blocks move at one moment."""

import math
from collections.abc import Iterable
from typing import NamedTuple

from singulate.geometry import BlockPose
from singulate.simulation.boxes import Vector3

_TREMBLE = 1e-5
"""What a block at rest moves or turns between two moments [m]; slower than 100 of it [1/s]."""


class BlockMotion(NamedTuple):
    """One block.

    Attributes:
        pose: Where it is.
        velocity: Of its centre [m/s].
        spin: Angular velocity [rad/s].
    """

    pose: BlockPose
    velocity: Vector3 = (0.0, 0.0, 0.0)
    spin: Vector3 = (0.0, 0.0, 0.0)


Motion = tuple[BlockMotion, ...]
"""All blocks of a scene."""


class TopSpeeds(NamedTuple):
    """How fast the fastest block is.

    Attributes:
        linear: Speed [m/s]; NaN where one is not a number.
        angular: Turning speed [rad/s]; likewise, not always of the same block.
    """

    linear: float
    angular: float


def fastest(velocities: Iterable[tuple[Vector3, Vector3]]) -> TopSpeeds:
    """The highest speeds of some blocks.

    Args:
        velocities: Velocity of the centre [m/s] and angular velocity [rad/s] of each.
    """
    linear, angular = [0.0], [0.0]
    for (vx, vy, vz), (wx, wy, wz) in velocities:
        linear.append(vx * vx + vy * vy + vz * vz)
        angular.append(wx * wx + wy * wy + wz * wz)
    return TopSpeeds(_highest_root(linear), _highest_root(angular))


def is_same(one: Motion, other: Motion) -> bool:
    """Whether two moments differ by nothing but the trembling of blocks at rest."""
    return all(
        math.dist(a.pose.position, b.pose.position) < _TREMBLE
        and math.dist(a.pose.quaternion, b.pose.quaternion) < _TREMBLE
        and max(math.hypot(*each) for each in (a.velocity, a.spin, b.velocity, b.spin))
        < 100 * _TREMBLE
        for a, b in zip(one, other, strict=True)
    )


def _highest_root(squares: list[float]) -> float:
    """Root of the highest; NaN where one is not a number."""
    return math.sqrt(math.nan if math.isnan(sum(squares)) else max(squares))
