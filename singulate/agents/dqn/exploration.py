"""Which discrete pushes a DQN tries."""

import numpy as np
import numpy.typing as npt

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.exploration import aimed_push
from singulate.agents.spatial.replay import as_distance_maps
from singulate.envs import GridActions
from singulate.geometry import Workspace

Actions = npt.NDArray[np.int64]


class GridExploration:
    """Now and then another push than the best: a uniform one, or one that is aimed at an object.

    Args:
        rng: Draws what is tried.
        observation: Name of the observation.
        aimed_share: Share of the explored pushes that are aimed; see `aimed_push`.

    Attributes:
        rng: See above.
    """

    def __init__(self, rng: np.random.Generator, observation: str, aimed_share: float) -> None:
        self.rng = rng
        self._observation = observation
        self._aimed_share = aimed_share
        self._workspace = Workspace()
        self._encoding = GridActions(self._workspace)

    def choose(self, greedy: Actions, images: FloatMap, rate: float) -> Actions:
        """The actions to execute.

        Args:
            greedy: The best ones, int64 (N,).
            images: What they were chosen for, float32 (N, H, W).
            rate: Probability of exploring.
        """
        is_explored = self.rng.random(len(greedy)) < rate
        explored = self.rng.integers(self._encoding.space.n, size=len(greedy))
        if self._aimed_share > 0.0:
            is_aimed = is_explored & (self.rng.random(len(greedy)) < self._aimed_share)
            for index in np.flatnonzero(is_aimed):
                explored[index] = self._aimed(images[index])
        return np.where(is_explored, explored, greedy)

    def _aimed(self, image: FloatMap) -> int:
        distance_map = as_distance_maps(image[None], self._observation)[0]
        return self._encoding.encode(aimed_push(distance_map, self._workspace, self.rng))
