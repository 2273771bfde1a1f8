"""Agents learn on rewards around one; everybody else sees the paper's units."""

from typing import Any

import gymnasium as gym
import numpy as np

REWARD_SCALE = 1e-3
"""Inside the agents, 1 is the paper's success reward of 1000 (section 3.2.3)."""


class ScaledReward(gym.Wrapper[Any, Any, Any, Any]):
    """Scales rewards for the agent; the unscaled one is ``info["reward"]``."""

    def step(
        self, action: np.ndarray[Any, Any] | np.integer[Any] | int
    ) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Step the environment and scale its reward by `REWARD_SCALE`."""
        observation, reward, terminated, truncated, info = self.env.step(action)
        info["reward"] = float(reward)
        return observation, float(reward) * REWARD_SCALE, terminated, truncated, info
