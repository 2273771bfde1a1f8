"""The yardstick: pushes drawn uniformly from everything that is allowed."""

import numpy as np

from singulate.agents.policy import FloatMap
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push, Workspace


class RandomPolicy:
    """Uniform start in the workspace, uniform cardinal direction (section 3.2.2)."""

    kind = "random"
    is_random = True

    def __init__(self, observation: str = "distance_map", workspace: Workspace | None = None):
        self.observation = observation
        self.workspace = workspace or Workspace()

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """A random push.

        Raises:
            InvalidValueError: Without a generator: nothing here is greedy.
        """
        if rng is None:
            raise InvalidValueError("rng", rng, "a numpy Generator for the random policy")
        limit = self.workspace.half_length
        x, y = rng.uniform(-limit, limit, size=2)
        direction = Direction(int(rng.integers(len(Direction))))
        return Push.cardinal((float(x), float(y)), direction, self.workspace.push_length)

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """None: it expects nothing."""
        return None
