"""Exploration that can be resumed, and what has to be saved for that."""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from gymnasium import spaces
from stable_baselines3.common.noise import ActionNoise
from stable_baselines3.common.policies import ContinuousCritic

from singulate.agents.off_policy.networks import Networks
from singulate.agents.off_policy.values import lower_values
from singulate.agents.overlap import OverlappedUpdates
from singulate.agents.replay import SeededReplayBuffer

Actions = npt.NDArray[np.float32]


class ActorCriticUpdates(OverlappedUpdates):
    """SAC or TD3 whose exploration and replay have generators of their own.

    With several environments an update happens while they push, as for the DQN.

    Attributes:
        exploration_rng: Draws what is tried.
        critic: Two networks that judge pushes.
        predicted_values: Expected (scaled) reward of the pushes chosen last, float32 (num_envs,).
    """

    critic: ContinuousCritic

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.exploration_rng = np.random.default_rng(self.seed)
        self.predicted_values: npt.NDArray[np.float32] = np.zeros(self.n_envs, np.float32)

    @property
    def generators(self) -> dict[str, np.random.Generator]:
        """Every generator of its own that training draws from, by name."""
        assert isinstance(self.replay_buffer, SeededReplayBuffer)
        return {"exploration": self.exploration_rng, "replay": self.replay_buffer.rng}

    @property
    def optimizers(self) -> dict[str, torch.optim.Optimizer]:
        """Every optimizer that training goes on with, by name."""
        networks = self.policy
        assert isinstance(networks, Networks)
        return {
            "actor_optimizer": networks.actor.optimizer,
            "critic_optimizer": networks.critic.optimizer,
        }

    def explore(self, observations: torch.Tensor) -> Actions:
        """Actions to try, float32 (batch, dims), on observations (batch, H, W)."""
        raise NotImplementedError

    def _sample_action(
        self, learning_starts: int, action_noise: ActionNoise | None = None, n_envs: int = 1
    ) -> tuple[Actions, Actions]:
        assert isinstance(self._last_obs, np.ndarray)
        assert isinstance(self.action_space, spaces.Box)
        observations = torch.as_tensor(self._last_obs)
        with torch.no_grad():
            if self.num_timesteps < learning_starts:
                drawn = self.exploration_rng.uniform(-1.0, 1.0, (n_envs, *self.action_space.shape))
                actions = drawn.astype(np.float32)
            else:
                actions = self.explore(observations)
            values = lower_values(self.critic, observations, torch.as_tensor(actions))
        self.predicted_values = values.numpy()
        return actions, actions
