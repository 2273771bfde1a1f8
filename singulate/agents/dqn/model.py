"""The DQN that is trained: stable-baselines3's, with an exploration that can be resumed."""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from gymnasium import spaces
from stable_baselines3 import DQN
from stable_baselines3.common.noise import ActionNoise
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.dqn.config import DQNConfig
from singulate.agents.dqn.replay import SymmetricReplayBuffer
from singulate.agents.dqn.update import gradient_step
from singulate.agents.network import policy_arguments
from singulate.agents.overlap import OverlappedSteps, OverlappedUpdates
from singulate.agents.spatial.exploration import aimed_push
from singulate.agents.spatial.replay import as_distance_maps
from singulate.envs import GridActions
from singulate.geometry import Workspace


class GridDQN(OverlappedUpdates, DQN):
    """DQN whose exploration depends on the number of pushes alone, with its own generator.

    stable-baselines3 ties exploration to the share of the training that is done, so extending a
    run would change its past, and draws it from NumPy's global generator.

    With several environments an update happens while they push, so between the choice of pushes
    and their result: a push is chosen by the network of one update before, and the update after
    the last push of a training is left to whoever continues it.

    Attributes:
        predicted_values: Expected (scaled) reward of the pushes chosen last, float32 (num_envs,).
    """

    def __init__(
        self,
        *args: Any,
        exploration_steps: int,
        exploration_aimed: float,
        observation: str,
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, **kwargs)
        self.exploration_steps = exploration_steps
        self.exploration_aimed = exploration_aimed
        self.exploration_rate = 1.0
        self._observation = observation
        self._workspace = Workspace()
        self._encoding = GridActions(self._workspace)
        self.exploration_rng = np.random.default_rng(self.seed)
        self.predicted_values: npt.NDArray[np.float32] = np.zeros(self.n_envs, np.float32)

    @property
    def generators(self) -> dict[str, np.random.Generator]:
        """Every generator of its own that training draws from, by name."""
        assert isinstance(self.replay_buffer, SymmetricReplayBuffer)
        return {"exploration": self.exploration_rng, "replay": self.replay_buffer.rng}

    def update(self, gradient_steps: int) -> None:
        """Improve the network by so many gradient steps; `DQN.train`, but faster."""
        self.policy.set_training_mode(True)
        self._update_learning_rate(self.policy.optimizer)
        losses = [gradient_step(self) for _ in range(gradient_steps)]
        self._n_updates += gradient_steps
        self.logger.record("train/n_updates", self._n_updates, exclude="tensorboard")
        self.logger.record("train/loss", np.mean(losses))

    def _on_step(self) -> None:
        super()._on_step()
        done = min(self.num_timesteps / self.exploration_steps, 1.0)
        self.exploration_rate = 1.0 + done * (self.exploration_final_eps - 1.0)
        self.logger.record("rollout/exploration_rate", self.exploration_rate)

    def _sample_action(
        self, learning_starts: int, action_noise: ActionNoise | None = None, n_envs: int = 1
    ) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        assert isinstance(self._last_obs, np.ndarray)
        assert isinstance(self.action_space, spaces.Discrete)
        with torch.no_grad():
            values = self.q_net(torch.as_tensor(self._last_obs)).numpy()
        rate = 1.0 if self.num_timesteps < learning_starts else self.exploration_rate
        is_random = self.exploration_rng.random(n_envs) < rate
        random_actions = self.exploration_rng.integers(self.action_space.n, size=n_envs)
        if self.exploration_aimed > 0.0:
            self._aim(random_actions, is_random)
        actions = np.where(is_random, random_actions, values.argmax(axis=1))
        self.predicted_values = values[np.arange(n_envs), actions]
        return actions, actions

    def _aim(self, actions: npt.NDArray[np.int64], is_random: npt.NDArray[np.bool_]) -> None:
        """Let its share of the explored pushes head for objects, in place."""
        is_aimed = is_random & (self.exploration_rng.random(len(actions)) < self.exploration_aimed)
        for index in np.flatnonzero(is_aimed):
            image = as_distance_maps(self._last_obs[[index]], self._observation)[0]
            push = aimed_push(image, self._workspace, self.exploration_rng)
            actions[index] = self._encoding.encode(push)


def build_model(config: DQNConfig, env: VecEnv, observation: str, seed: int) -> GridDQN:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``grid`` actions.
        observation: Name of its observation.
        seed: Seeds the network and all random choices.
    """
    steps = OverlappedSteps(env) if env.num_envs > 1 else env
    model = GridDQN(
        "MlpPolicy",
        steps,
        learning_rate=config.learning_rate,
        buffer_size=config.buffer_size,
        learning_starts=config.learning_starts,
        batch_size=config.batch_size,
        gamma=config.gamma,
        train_freq=1,
        gradient_steps=config.gradient_steps * env.num_envs,
        replay_buffer_class=SymmetricReplayBuffer,
        replay_buffer_kwargs={
            "seed": seed,
            "best_share": config.best_share,
            "symmetries": config.symmetries,
        },
        target_update_interval=config.target_update_interval,
        tau=config.tau,
        exploration_final_eps=config.exploration_final_eps,
        exploration_steps=config.exploration_steps,
        exploration_aimed=config.exploration_aimed,
        observation=observation,
        policy_kwargs=network_arguments(config, observation),
        seed=seed,
        device="cpu",
    )
    if isinstance(steps, OverlappedSteps):
        steps.meanwhile = model.update_meanwhile
    return model


def network_arguments(config: DQNConfig, observation: str) -> dict[str, object]:
    """Arguments of stable-baselines3's DQN policy."""
    shared = policy_arguments(observation, adam_epsilon=1e-8, encoder=config.encoder)
    return {"net_arch": list(config.net_arch), **shared}


def network_of(model: GridDQN) -> torch.nn.Module:
    """The part of a model that acting needs: its Q network, averaged if that is its way."""
    return model.q_net if model.tau == 1.0 else model.q_net_target
