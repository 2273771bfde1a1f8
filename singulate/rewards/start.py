"""r_Start: pays for starting near an object, but not too near (paper, Eq. 4)."""

import math
from functools import lru_cache
from typing import NamedTuple

from singulate.exceptions import InvalidValueError
from singulate.geometry import Push, Workspace
from singulate.perception import Percept

GOAL_DISTANCE = 0.2
"""d_Goal, the distance from the closest object at which r_Start peaks [m]."""


class StartConstants(NamedTuple):
    """K1 to K4 of Eq. 4; distances in metres."""

    k1: float
    k2: float
    k3: float
    k4: float


@lru_cache
def start_constants(goal: float, diagonal: float) -> StartConstants:
    r"""Solve Eq. 4 for the constants that the paper leaves open.

    With g the goal distance, D the workspace's diagonal and s(d) = 1 / (1 + exp(-d)), both branches
    have two constants each, and the paper's description gives each two conditions:

    - at the object the reward vanishes, K1 s(0) + K2 = 0, and at the goal it peaks at 1,
      K1 s(g) + K2 = 1. The difference gives K1 = 1 / (s(g) - s(0)), and with s(0) = 1/2,
      K2 = -K1 / 2.
    - the second branch starts where the first ends, K3 / g + K4 = 1, and vanishes at the largest
      distance there is, K3 / D + K4 = 0. Hence K4 = -K3 / D, K3 (1/g - 1/D) = 1, and so
      K3 = g D / (D - g), K4 = -g / (D - g).

    For g = 0.2 m and D = 2 sqrt(2) m: 20.067, -10.033, 0.21522 m and -0.07609.

    Args:
        goal: g [m].
        diagonal: D [m].

    Returns:
        K1, K2, K4 without unit, K3 [m].

    Raises:
        InvalidValueError: Unless 0 < goal < diagonal.
    """
    if not 0.0 < goal < diagonal:
        raise InvalidValueError("goal", goal, f"more than 0 and less than the diagonal, {diagonal}")
    k1 = 1.0 / (_sigmoid(goal) - _sigmoid(0.0))
    return StartConstants(
        k1=k1, k2=-k1 / 2.0, k3=goal * diagonal / (diagonal - goal), k4=-goal / (diagonal - goal)
    )


def start_reward(d_object: float, workspace: Workspace) -> float:
    """r_Start of a push (paper, Eq. 4), without its weight.

    Args:
        d_object: Distance of the push's start from the closest object [m]; 0 inside.
        workspace: Its diagonal is where the reward has fallen to 0 again.

    Returns:
        0 at the object, rising to 1 at 0.2 m, falling to 0 at the workspace's diagonal; continuous.
    """
    k1, k2, k3, k4 = start_constants(GOAL_DISTANCE, workspace.diagonal)
    if d_object <= GOAL_DISTANCE:
        return k1 * _sigmoid(d_object) + k2
    return k3 / min(d_object, workspace.diagonal) + k4


def object_distance(percept: Percept, push: Push, workspace: Workspace) -> float:
    """d_Object: distance of a push's start from the closest object, as the picture shows it.

    Args:
        percept: The scene before the push.
        push: Its start decides; a start beyond the image counts as in the border pixel nearest.
        workspace: Maps the start to a pixel, and pixels to metres.

    Returns:
        The distance map's value at the start's pixel [m]; 0 inside an object.
    """
    distance_px = float(percept.distance_map[workspace.xy_to_row_col(*push.start)])
    return max(distance_px, 0.0) * workspace.metres_per_pixel


def _sigmoid(x: float) -> float:
    return 1.0 / (1.0 + math.exp(-x))
