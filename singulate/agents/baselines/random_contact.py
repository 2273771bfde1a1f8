"""A fairer yardstick than a random push: a random push among those that hit something."""

import numpy as np
import numpy.typing as npt

from singulate.agents.baselines.observed_mask import boxes_with_points, mask_of, object_points
from singulate.agents.policy import FloatMap
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push, Workspace
from singulate.simulation import Physics

NUM_TRIES = 256
"""Pushes drawn at once; on random-2 about 20 of them hit something."""
MAX_ROUNDS = 100

_VECTORS = np.array([direction.vector for direction in Direction])


class RandomContactPolicy:
    """Uniform over cardinal pushes whose swept footprint touches the mask.

    The start's own footprint must be free, because a gripper cannot be lowered onto an object.
    Where no such push is found, any push will do.
    """

    kind = "random-contact"
    is_random = True

    def __init__(self, observation: str = "distance_map", workspace: Workspace | None = None):
        self.observation = observation
        self.workspace = workspace or Workspace()
        self._pusher_side = Physics().pusher_side

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """A random push that hits something.

        Raises:
            InvalidValueError: Without a generator: nothing here is greedy.
        """
        if rng is None:
            raise InvalidValueError("rng", rng, "a numpy Generator for the random-contact policy")
        workspace = self.workspace
        mask = mask_of(observation, self.observation)
        points = object_points(mask, workspace.metres_per_pixel)
        for _ in range(MAX_ROUNDS):
            starts = rng.uniform(-workspace.half_length, workspace.half_length, (NUM_TRIES, 2))
            directions = rng.integers(len(Direction), size=NUM_TRIES)
            hits = np.flatnonzero(self._hits(starts, directions, points))
            if hits.size:
                break
        chosen = hits[0] if hits.size else 0
        x, y = starts[chosen]
        direction = Direction(int(directions[chosen]))
        return Push.cardinal((float(x), float(y)), direction, workspace.push_length)

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """None: it expects nothing."""
        return None

    def _hits(
        self,
        starts: npt.NDArray[np.float64],
        directions: npt.NDArray[np.int64],
        points: npt.NDArray[np.float64],
    ) -> npt.NDArray[np.bool_]:
        """Which pushes start freely and sweep over an object's pixel, (N,)."""
        half = (self._pusher_side + self.workspace.metres_per_pixel) / 2  # a pixel's edge counts
        reach = _VECTORS[directions] * self.workspace.push_length / 2  # (N, 2)
        at_start = boxes_with_points(starts, np.full_like(starts, half), points)
        swept = boxes_with_points(starts + reach, np.abs(reach) + half, points)
        return swept & ~at_start
