"""Replay memory with, on request, symmetric copies."""

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from gymnasium import spaces
from stable_baselines3.common.type_aliases import ReplayBufferSamples
from stable_baselines3.common.vec_env import VecNormalize

from singulate.agents.dqn.symmetry import NUM_SYMMETRIES, action_table, transform_images
from singulate.agents.replay import SeededReplayBuffer


class SymmetricReplayBuffer(SeededReplayBuffer):
    """Uniform replay of pushes with ``grid`` actions.

    Args:
        symmetries: Whether each sampled push is turned and mirrored at random.
    """

    def __init__(self, *args: Any, symmetries: bool, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.symmetries = symmetries
        assert isinstance(self.action_space, spaces.Discrete)
        self._action_table = action_table(math.isqrt(int(self.action_space.n) // 4))

    def sample(self, batch_size: int, env: VecNormalize | None = None) -> ReplayBufferSamples:
        """Draw pushes with replacement; observations are (batch, H, W)."""
        batch = super().sample(batch_size, env)
        if not self.symmetries:
            return batch
        symmetries = self.rng.integers(0, NUM_SYMMETRIES, size=batch_size)
        observations = _transform_each(batch.observations, symmetries)
        is_same = batch.next_observations is batch.observations
        following = (
            observations if is_same else _transform_each(batch.next_observations, symmetries)
        )
        actions = self._action_table[symmetries[:, None], batch.actions.numpy()]
        return batch._replace(
            observations=observations,
            next_observations=following,
            actions=torch.from_numpy(actions),
        )


def _transform_each(images: torch.Tensor, symmetries: npt.NDArray[np.int64]) -> torch.Tensor:
    originals = images.numpy()
    transformed = np.empty_like(originals)
    for symmetry in range(NUM_SYMMETRIES):
        rows = np.flatnonzero(symmetries == symmetry)
        transformed[rows] = transform_images(originals[rows], symmetry)
    return torch.from_numpy(transformed)
