"""Random pushes that are aimed at objects: others move nothing and teach little."""

import numpy as np
import numpy.typing as npt

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.choice import push_at
from singulate.agents.spatial.turning import turn_all_ways
from singulate.geometry import Direction, Push, Workspace

NEAR = 0.375
"""Aimed pushes start at most this far from an object [m]; beyond, they hardly move it."""


def aimed_push(distance_map: FloatMap, workspace: Workspace, rng: np.random.Generator) -> Push:
    """A push that starts near an object, outside of it, and heads for one.

    Uniform over all such pixels and directions, and within the pixel. As in hybrid-pushing, where
    half of the exploration is aimed at objects.

    Args:
        distance_map: float32 (H, H) [px], -1 inside objects.
        workspace: Gives the size of a pixel and the length of a push.
        rng: Draws the push.
    """
    turned = turn_all_ways(distance_map)
    is_near = (turned > 0.0) & (turned <= NEAR / workspace.metres_per_pixel)
    candidates = np.argwhere(is_near & _is_object_ahead(turned < 0.0, workspace))
    if not len(candidates):
        candidates = np.argwhere(np.ones_like(is_near))
    direction, row, column = candidates[rng.integers(len(candidates))]
    down, right = rng.uniform(-0.5, 0.5, size=2)
    return push_at(row + down, column + right, Direction(int(direction)), workspace)


def _is_object_ahead(
    is_object: npt.NDArray[np.bool_], workspace: Workspace
) -> npt.NDArray[np.bool_]:
    """Whether the middle line of a push upwards meets an object, (N, H, W) like the masks."""
    length = round(workspace.push_length / workspace.metres_per_pixel)
    padded = np.pad(is_object, ((0, 0), (length, 0), (0, 0)))
    lines = np.lib.stride_tricks.sliding_window_view(padded, length + 1, axis=1)
    return np.asarray(lines.any(axis=-1))
