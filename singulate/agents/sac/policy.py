"""A trained SAC, ready to push."""

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.sac.policies import Actor, SACPolicy

from singulate.agents.gaussian.density import squashed_start_density
from singulate.agents.observation import batch_of_one
from singulate.agents.off_policy.networks import network_arguments
from singulate.agents.off_policy.policy import ActorCriticPolicy
from singulate.agents.policy import FloatMap
from singulate.agents.sac.config import SACConfig
from singulate.envs import EnvConfig
from singulate.geometry import Push

FloatVector = npt.NDArray[np.float64]


class SquashedGaussianPolicy(ActorCriticPolicy):
    """Draws pushes from a Gaussian that a network places, squashed into the workspace by tanh."""

    kind = "sac"
    is_random = True

    def __init__(self, config: SACConfig, env_config: EnvConfig) -> None:
        arguments = network_arguments(config.net_arch, env_config.observation)
        super().__init__(SACPolicy, arguments, env_config)

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The push at the Gaussian's mean; with `rng`, one that is drawn, as in training."""
        mean, deviation = self.action_distribution(observation)
        action = mean if rng is None else rng.normal(mean, deviation)
        return self._encoding.decode(np.tanh(action).astype(np.float32))

    def start_density(self, observation: FloatMap) -> FloatMap:
        """Probability that a push starts in each image cell, float32 (H, W), summing to 1."""
        mean, deviation = self.action_distribution(observation)
        return squashed_start_density(mean[:2], deviation[:2], self.workspace.image_size)

    def action_distribution(self, observation: FloatMap) -> tuple[FloatVector, FloatVector]:
        """Mean and standard deviation of the action before tanh, float64 (dims,) each."""
        actor = self.network.actor
        assert isinstance(actor, Actor)
        picture = batch_of_one(observation, self.workspace.image_size)
        with torch.no_grad():
            mean, log_std, _ = actor.get_action_dist_params(picture)
        deviation = log_std[0].exp().numpy()
        return mean[0].numpy().astype(np.float64), deviation.astype(np.float64)


def build_policy(config: SACConfig, env_config: EnvConfig) -> SquashedGaussianPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return SquashedGaussianPolicy(config, env_config)
