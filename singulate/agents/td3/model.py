"""The TD3 that is trained: stable-baselines3's, with an exploration that can be resumed."""

from typing import Any

import numpy as np
import torch
from stable_baselines3 import TD3
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.off_policy.algorithm import Actions, ActorCriticUpdates
from singulate.agents.off_policy.networks import ActorAndCritics, network_arguments
from singulate.agents.overlap import OverlappedSteps
from singulate.agents.replay import SeededReplayBuffer
from singulate.agents.td3.config import TD3Config


class PushTD3(ActorCriticUpdates, TD3):
    """TD3 that tries its push with noise.

    Args:
        exploration_noise: Standard deviation of the noise.
    """

    def __init__(self, *args: Any, exploration_noise: float, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.exploration_noise = exploration_noise

    def update(self, gradient_steps: int) -> None:
        """Improve the critics by so many gradient steps, and the actor by its share of them."""
        TD3.train(self, gradient_steps, self.batch_size)

    def explore(self, observations: torch.Tensor) -> Actions:
        """Actions of the actor, with noise, clipped to the action space, float32 (batch, dims)."""
        actions: torch.Tensor = self.actor(observations)
        noisy = self.exploration_rng.normal(actions.numpy(), self.exploration_noise)
        return np.clip(noisy, -1.0, 1.0).astype(np.float32)


def build_model(config: TD3Config, env: VecEnv, observation: str, seed: int) -> PushTD3:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` or ``start_end`` actions.
        observation: Name of its observation.
        seed: Seeds the networks and all random choices.
    """
    steps = OverlappedSteps(env) if env.num_envs > 1 else env
    model = PushTD3(
        "MlpPolicy",
        steps,
        exploration_noise=config.exploration_noise,
        learning_rate=config.learning_rate,
        buffer_size=config.buffer_size,
        learning_starts=config.learning_starts,
        batch_size=config.batch_size,
        tau=config.tau,
        gamma=config.gamma,
        train_freq=1,
        gradient_steps=config.gradient_steps * env.num_envs,
        replay_buffer_class=SeededReplayBuffer,
        replay_buffer_kwargs={"seed": seed},
        policy_delay=config.policy_delay,
        target_policy_noise=config.target_policy_noise,
        target_noise_clip=config.target_noise_clip,
        policy_kwargs=network_arguments(config.net_arch, observation),
        seed=seed,
        device="cpu",
    )
    if isinstance(steps, OverlappedSteps):
        steps.meanwhile = model.update_meanwhile
    return model


def network_of(model: PushTD3) -> torch.nn.Module:
    """The part of a model that acting and judging pushes need."""
    return ActorAndCritics(model.policy)
