"""The DQN that is trained: stable-baselines3's, with an exploration that can be resumed."""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3 import DQN
from stable_baselines3.common.noise import ActionNoise
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.annealing import annealed, set_learning_rate
from singulate.agents.dqn.config import DQNConfig
from singulate.agents.dqn.exploration import GridExploration
from singulate.agents.dqn.replay import SymmetricReplayBuffer
from singulate.agents.dqn.update import gradient_step
from singulate.agents.network import policy_arguments
from singulate.agents.overlap import OverlappedSteps, OverlappedUpdates


class GridDQN(OverlappedUpdates, DQN):
    """DQN whose exploration and step size depend on the number of pushes alone.

    Exploration has its own generator (stable-baselines3 draws it from NumPy's global one).

    With several environments an update happens while they push, so between the choice of pushes
    and their result: a push is chosen by the network of one update before, and the update after
    the last push of a training is left to whoever continues it.

    Args:
        config: Its settings.
        observation: Name of the observation.

    Attributes:
        exploration: Chooses what is tried.
        predicted_values: Expected (scaled) reward of the pushes chosen last, float32 (num_envs,).
    """

    def __init__(
        self,
        *args: Any,
        config: DQNConfig,
        observation: str,
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, **kwargs)
        self.config = config
        self.exploration_rate = 1.0
        rng = np.random.default_rng(self.seed)
        self.exploration = GridExploration(rng, observation, config.exploration_aimed)
        self.predicted_values: npt.NDArray[np.float32] = np.zeros(self.n_envs, np.float32)

    @property
    def generators(self) -> dict[str, np.random.Generator]:
        """Every generator of its own that training draws from, by name."""
        assert isinstance(self.replay_buffer, SymmetricReplayBuffer)
        return {"exploration": self.exploration.rng, "replay": self.replay_buffer.rng}

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
        self.exploration_rate = annealed(
            1.0,
            self.config.exploration_final_eps,
            self.num_timesteps,
            self.config.exploration_steps,
        )
        self.logger.record("rollout/exploration_rate", self.exploration_rate)

    def _update_learning_rate(
        self, optimizers: list[torch.optim.Optimizer] | torch.optim.Optimizer
    ) -> None:
        rate, final = self.config.learning_rate, self.config.final_learning_rate
        over = self.config.anneal_steps
        if final is not None and over is not None:
            rate = annealed(rate, final, self.num_timesteps, over)
        set_learning_rate(self, optimizers, rate)

    def _sample_action(
        self, learning_starts: int, action_noise: ActionNoise | None = None, n_envs: int = 1
    ) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        assert isinstance(self._last_obs, np.ndarray)
        with torch.no_grad():
            values = self.q_net(torch.as_tensor(self._last_obs)).numpy()
        rate = 1.0 if self.num_timesteps < learning_starts else self.exploration_rate
        actions = self.exploration.choose(values.argmax(axis=1), self._last_obs, rate)
        self.predicted_values = values[np.arange(n_envs), actions]
        return actions, actions


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
        config=config,
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
