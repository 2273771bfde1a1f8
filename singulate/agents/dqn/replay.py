"""Replay memory with a random generator of its own and, on request, symmetric copies."""

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from gymnasium import spaces
from stable_baselines3.common.buffers import ReplayBuffer
from stable_baselines3.common.type_aliases import ReplayBufferSamples
from stable_baselines3.common.vec_env import VecNormalize

from singulate.agents.dqn.symmetry import NUM_SYMMETRIES, action_table, transform_images


class SymmetricReplayBuffer(ReplayBuffer):
    """Uniform replay of pushes.

    Args:
        seed: Seed of the memory's own generator.
        symmetries: Whether each sampled push is turned and mirrored at random.
    """

    def __init__(self, *args: Any, seed: int, symmetries: bool, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.rng = np.random.default_rng(seed)
        self.symmetries = symmetries
        assert isinstance(self.action_space, spaces.Discrete)
        self._action_table = action_table(math.isqrt(int(self.action_space.n) // 4))

    def sample(self, batch_size: int, env: VecNormalize | None = None) -> ReplayBufferSamples:
        """Draw pushes with replacement; observations are (batch, H, W)."""
        size = self.buffer_size if self.full else self.pos
        drawn = self.rng.integers(0, size * self.n_envs, size=batch_size)
        chosen = np.divmod(drawn, self.n_envs)
        observations = self.observations[chosen]
        actions = self.actions[chosen]
        dones = (self.dones[chosen] * (1.0 - self.timeouts[chosen]))[:, None]
        # What follows the last push of an episode has no effect, so any image will do.
        next_observations = observations if dones.all() else self.next_observations[chosen]
        if self.symmetries:
            symmetries = self.rng.integers(0, NUM_SYMMETRIES, size=batch_size)
            is_same = next_observations is observations
            observations = _transform_each(observations, symmetries)
            next_observations = (
                observations if is_same else _transform_each(next_observations, symmetries)
            )
            actions = self._action_table[symmetries[:, None], actions]
        arrays = (observations, actions, next_observations, dones, self.rewards[chosen][:, None])
        return ReplayBufferSamples(*map(torch.from_numpy, arrays))


def _transform_each(
    images: npt.NDArray[np.float32], symmetries: npt.NDArray[np.int64]
) -> npt.NDArray[np.float32]:
    transformed = np.empty_like(images)
    for symmetry in range(NUM_SYMMETRIES):
        rows = np.flatnonzero(symmetries == symmetry)
        transformed[rows] = transform_images(images[rows], symmetry)
    return transformed
