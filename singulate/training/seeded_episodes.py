"""Training episodes seeded one by one, so that a run can be continued exactly."""

from collections.abc import Mapping
from typing import Any

import gymnasium as gym
import numpy as np
import numpy.typing as npt

from singulate.envs import scene_seed
from singulate.training.environment import TrainingEnv


class SeededEpisodes(gym.Wrapper[Any, Any, Any, Any]):
    """Gives episode number i of a run its own seed, whatever seed `reset` is asked for.

    The state of the environment is then the episode's number and the actions taken in it: pushes
    are pure functions, so replaying them restores it bit for bit.

    Args:
        env: The environment.
        run_seed: Seed of the run.
    """

    def __init__(self, env: TrainingEnv, run_seed: int) -> None:
        super().__init__(env)
        self.push_env = env
        self.run_seed = run_seed
        self.episode_index = -1
        self._actions: list[Any] = []

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        """Begin the next episode."""
        return self._begin(self.episode_index + 1)

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        """Step, and remember the action."""
        self._actions.append(np.asarray(action).tolist())
        observation, reward, terminated, truncated, info = self.env.step(action)
        info["episode_index"] = self.episode_index
        return observation, reward, terminated, truncated, info

    @property
    def state(self) -> dict[str, Any]:
        """What `restore` needs, as plain values."""
        return {
            "episode_index": self.episode_index,
            "actions": list(self._actions),
            "num_pushes": self.push_env.num_pushes,
        }

    def restore(self, state: Mapping[str, Any]) -> npt.NDArray[np.float32]:
        """Return to a state and give its observation, float32 (H, W)."""
        observation, _ = self._begin(int(state["episode_index"]))
        dtype = self.push_env.action_space.dtype
        for action in state["actions"]:
            observation = self.step(np.asarray(action, dtype=dtype))[0]
        self.push_env.num_pushes = int(state["num_pushes"])
        return observation

    def _begin(self, episode_index: int) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        self.episode_index = episode_index
        self._actions = []
        return self.env.reset(seed=scene_seed("training", self.run_seed, episode_index))
