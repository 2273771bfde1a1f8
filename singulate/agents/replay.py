"""Replay memory with a random generator of its own."""

from typing import Any

import numpy as np
import torch
from stable_baselines3.common.buffers import ReplayBuffer
from stable_baselines3.common.type_aliases import ReplayBufferSamples
from stable_baselines3.common.vec_env import VecNormalize


class SeededReplayBuffer(ReplayBuffer):
    """Uniform replay of pushes, 32 KiB each.

    Args:
        seed: Seed of the memory's own generator.

    Attributes:
        rng: That generator.
    """

    def __init__(self, *args: Any, seed: int, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.rng = np.random.default_rng(seed)

    def sample(self, batch_size: int, env: VecNormalize | None = None) -> ReplayBufferSamples:
        """Draw pushes with replacement; observations are (batch, H, W)."""
        size = self.buffer_size if self.full else self.pos
        drawn = self.rng.integers(0, size * self.n_envs, size=batch_size)
        chosen = np.divmod(drawn, self.n_envs)
        observations = torch.from_numpy(self.observations[chosen])
        dones = (self.dones[chosen] * (1.0 - self.timeouts[chosen]))[:, None]
        # What follows the last push of an episode has no effect, so any image will do.
        is_over = bool(dones.all())
        following = observations if is_over else torch.from_numpy(self.next_observations[chosen])
        actions, rewards = self.actions[chosen], self.rewards[chosen][:, None]
        rest = map(torch.from_numpy, (dones, rewards))
        return ReplayBufferSamples(observations, torch.from_numpy(actions), following, *rest)
