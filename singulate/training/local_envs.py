"""The environments of a training in the trainer's own process."""

from collections.abc import Sequence
from functools import partial

import numpy as np
import numpy.typing as npt
from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.reward_scale import ScaledReward
from singulate.training.config import TrainingConfig
from singulate.training.environment import make_training_env
from singulate.training.episode_state import EpisodeState
from singulate.training.seeded_episodes import SeededEpisodes
from singulate.training.workers.supervisor import WorkerLoss


class LocalEnvs(DummyVecEnv):
    """Environments that push one after the other.

    Args:
        config: The run's settings.
    """

    def __init__(self, config: TrainingConfig) -> None:
        self.config = config
        self._episodes = [
            SeededEpisodes(
                make_training_env(config),
                config.seed,
                EpisodeState.initial(index, config.num_envs),
            )
            for index in range(config.num_envs)
        ]
        super().__init__([partial(ScaledReward, episodes) for episodes in self._episodes])

    @property
    def states(self) -> list[EpisodeState]:
        """Where each environment is, for `restore`."""
        return [episodes.state for episodes in self._episodes]

    def restore(self, states: Sequence[EpisodeState]) -> npt.NDArray[np.float32]:
        """Return to states and give their observations, float32 (num_envs, H, W)."""
        pairs = zip(self._episodes, states, strict=True)
        return np.stack([episodes.restore(state) for episodes, state in pairs])

    def take_losses(self) -> list[WorkerLoss]:
        """None: there are no workers to lose."""
        return []
