"""Replay memory with a random generator of its own."""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.common.buffers import ReplayBuffer
from stable_baselines3.common.type_aliases import ReplayBufferSamples
from stable_baselines3.common.vec_env import VecNormalize

_BEST_PART = 10
"""One push in so many counts among the best."""


class SeededReplayBuffer(ReplayBuffer):
    """Replay of pushes, 32 KiB each.

    Args:
        seed: Seed of the memory's own generator.
        best_share: Share of a batch that is drawn among the tenth with the highest rewards, as in
            hybrid-pushing's stratified replay; the rest is drawn among all.

    Attributes:
        rng: That generator.
    """

    def __init__(self, *args: Any, seed: int, best_share: float = 0.0, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.rng = np.random.default_rng(seed)
        self.best_share = best_share

    def draw(self, batch_size: int) -> npt.NDArray[np.int64]:
        """Numbers of pushes, counted over all environments, with replacement."""
        size = self.size() * self.n_envs
        drawn = self.rng.integers(0, size, size=batch_size)
        num_best = size // _BEST_PART
        num_from_best = int(batch_size * self.best_share) if num_best else 0
        if num_from_best:
            rewards = self.rewards[: self.size()].ravel()
            best = np.argpartition(-rewards, num_best - 1)[:num_best]
            drawn[:num_from_best] = best[self.rng.integers(0, num_best, size=num_from_best)]
        return drawn

    def sample(self, batch_size: int, env: VecNormalize | None = None) -> ReplayBufferSamples:
        """Draw pushes with replacement; observations are (batch, H, W)."""
        chosen = np.divmod(self.draw(batch_size), self.n_envs)
        observations = torch.from_numpy(self.observations[chosen])
        dones = (self.dones[chosen] * (1.0 - self.timeouts[chosen]))[:, None]
        # What follows the last push of an episode has no effect, so any image will do.
        is_over = bool(dones.all())
        following = observations if is_over else torch.from_numpy(self.next_observations[chosen])
        actions, rewards = self.actions[chosen], self.rewards[chosen][:, None]
        rest = map(torch.from_numpy, (dones, rewards))
        return ReplayBufferSamples(observations, torch.from_numpy(actions), following, *rest)
