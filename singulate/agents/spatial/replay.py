"""Replay memory that returns successes more often, and windows instead of pictures."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.policy import FloatMap
from singulate.agents.replay import SeededReplayBuffer
from singulate.agents.spatial.turning import to_turned_pixels, turn_each
from singulate.agents.spatial.window import cut_windows, mirror_each
from singulate.perception import distance_map


class PushBatch(NamedTuple):
    """Pushes to learn from.

    Attributes:
        canvases: What lies around their starts, turned so that they point up, (N, height, width).
        pixels: Where they start in the cell of values that a canvas gives, (N, 2).
        rewards: Their scaled rewards, (N,).
    """

    canvases: torch.Tensor
    pixels: torch.Tensor
    rewards: torch.Tensor


class PushMemory(SeededReplayBuffer):
    """Pushes with ``point`` actions.

    Args:
        observation: Name of the observations in it.
    """

    def __init__(self, *args: Any, observation: str, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._observation = observation

    def sample_pushes(self, batch_size: int) -> PushBatch:
        """Draw pushes with replacement, each mirrored or not."""
        chosen = np.divmod(self.draw(batch_size), self.n_envs)
        actions = self.actions[chosen].astype(np.float64)
        directions = directions_of(actions)
        maps = as_distance_maps(self.observations[chosen], self._observation)
        turned = turn_each(maps, directions)
        pixels = to_turned_pixels(actions[:, :2], directions, maps.shape[1])
        is_mirrored = self.rng.random(batch_size) < 0.5
        turned, pixels = mirror_each(turned, pixels, is_mirrored)
        windows = cut_windows(turned, pixels, self.rng)
        arrays = (windows.canvases, windows.pixels, self.rewards[chosen])
        return PushBatch(*map(torch.from_numpy, arrays))


def directions_of(actions: npt.NDArray[np.float64]) -> npt.NDArray[np.int64]:
    """Direction of each ``point`` action, (N, 3): c in four equal bins (section 3.2.2)."""
    return np.minimum((actions[:, 2] + 1.0) * 2.0, 3.0).astype(np.int64)


def as_distance_maps(observations: FloatMap, observation: str) -> FloatMap:
    """Distance maps, float32 (N, H, W) [px], from either kind of observation."""
    if observation == "distance_map":
        return observations
    return np.stack([distance_map(image > 0.5) for image in observations])
