"""Replay memory with a random generator of its own and, on request, symmetric copies."""

import math
from typing import Any

import numpy as np
import numpy.typing as npt
from gymnasium import spaces
from stable_baselines3.common.buffers import ReplayBuffer
from stable_baselines3.common.type_aliases import ReplayBufferSamples
from stable_baselines3.common.vec_env import VecNormalize

from singulate.agents.dqn.symmetry import NUM_SYMMETRIES, action_table, transform_images


class SymmetricReplayBuffer(ReplayBuffer):
    """Uniform replay of a single environment's pushes.

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
        rows = self.rng.integers(0, size, size=batch_size)
        observations = self.observations[rows, 0]
        actions = self.actions[rows, 0]
        dones = self.dones[rows] * (1.0 - self.timeouts[rows])
        # What follows the last push of an episode has no effect, so any image will do.
        next_observations = observations if dones.all() else self.next_observations[rows, 0]
        if self.symmetries:
            chosen = self.rng.integers(0, NUM_SYMMETRIES, size=batch_size)
            is_same = next_observations is observations
            observations = _transform_each(observations, chosen)
            next_observations = (
                observations if is_same else _transform_each(next_observations, chosen)
            )
            actions = self._action_table[chosen[:, None], actions]
        arrays = (observations, actions, next_observations, dones, self.rewards[rows])
        return ReplayBufferSamples(*map(self.to_torch, arrays))


def _transform_each(
    images: npt.NDArray[np.float32], symmetries: npt.NDArray[np.int64]
) -> npt.NDArray[np.float32]:
    transformed = np.empty_like(images)
    for symmetry in range(NUM_SYMMETRIES):
        rows = np.flatnonzero(symmetries == symmetry)
        transformed[rows] = transform_images(images[rows], symmetry)
    return transformed
