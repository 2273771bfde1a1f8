"""A trained TD3, ready to push."""

import numpy as np
import torch
from stable_baselines3.td3.policies import TD3Policy

from singulate.agents.observation import batch_of_one
from singulate.agents.off_policy.networks import network_arguments
from singulate.agents.off_policy.policy import ActorCriticPolicy
from singulate.agents.policy import FloatMap
from singulate.agents.td3.config import TD3Config
from singulate.envs import EnvConfig
from singulate.geometry import Push


class DeterministicPolicy(ActorCriticPolicy):
    """Makes the one push that a network gives."""

    kind = "td3"
    is_random = False

    def __init__(self, config: TD3Config, env_config: EnvConfig) -> None:
        arguments = network_arguments(config.net_arch, env_config.observation)
        super().__init__(TD3Policy, arguments, env_config)
        self._exploration_noise = config.exploration_noise

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The actor's push; with `rng`, with noise, as in training."""
        picture = batch_of_one(observation, self.workspace.image_size)
        with torch.no_grad():
            action = self.network.actor(picture)[0].numpy()
        if rng is not None:
            action = np.clip(rng.normal(action, self._exploration_noise), -1.0, 1.0)
        return self._encoding.decode(action)


def build_policy(config: TD3Config, env_config: EnvConfig) -> DeterministicPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return DeterministicPolicy(config, env_config)
