"""Training episodes seeded one by one, so that a run can be continued exactly."""

from typing import Any

import gymnasium as gym
import numpy as np
import numpy.typing as npt

from singulate.envs import PushEnv, scene_seed
from singulate.training.environment import TrainingEnv
from singulate.training.episode_state import EpisodeState

Observation = npt.NDArray[np.float32]


class SeededEpisodes(gym.Wrapper[Any, Any, Any, Any]):
    """Gives every episode of a run its own seed, whatever seed `reset` is asked for.

    Args:
        env: The environment.
        run_seed: Seed of the run.
        state: Where to begin; by default as the only environment of a new run.

    Attributes:
        state: Where the environment is, for `restore`.
    """

    def __init__(self, env: TrainingEnv, run_seed: int, state: EpisodeState | None = None) -> None:
        super().__init__(env)
        self.push_env = env
        self.run_seed = run_seed
        self.state = state or EpisodeState.initial()
        self._loss = ""

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin the next episode."""
        self.state = self.state.after_reset()
        return self._begin()

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        """Step, and remember the action."""
        self.push_env.num_pushes = self.state.num_pushes
        self.state = self.state.after_push(action)
        loss, self._loss = self._loss, ""
        result = self._lose(action, loss) if loss else self.env.step(action)
        result[-1]["episode_index"] = self.state.episode_index
        return result

    def lose_next_push(self, reason: str) -> None:
        """Let the next step truncate the episode without pushing.

        Args:
            reason: What made the push impossible, one line.
        """
        self._loss = reason

    def restore(self, state: EpisodeState) -> Observation:
        """Return to a state and give its observation, float32 (H, W)."""
        self.state = EpisodeState(state.num_envs, state.episode_index, state.num_pushes)
        observation, _ = self._begin()
        dtype = self.push_env.action_space.dtype
        for action in state.actions:
            observation = self.step(np.asarray(action, dtype=dtype))[0]
        self.state = state
        return observation

    def _lose(self, action: Any, reason: str) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        assert isinstance(self.push_env, PushEnv)  # only workers are lost, and they simulate
        return self.push_env.lose(action, reason)

    def _begin(self) -> tuple[Observation, dict[str, Any]]:
        index = self.state.episode_index
        return self.env.reset(seed=scene_seed("training", self.run_seed, index))
