"""A trained PPO with a density of its own, ready to push."""

from collections.abc import Callable

import numpy as np
import torch

from singulate.agents.density_ppo.actor_critic import DensityActorCritic
from singulate.agents.density_ppo.config import DensityPPOConfig
from singulate.agents.density_ppo.distribution import PointDistribution
from singulate.agents.density_ppo.model import actor_critic_arguments
from singulate.agents.density_ppo.network import TurnedNet
from singulate.agents.observation import batch_of_one
from singulate.agents.policy import FloatMap
from singulate.agents.reward_scale import REWARD_SCALE
from singulate.envs import EnvConfig, PointActions, make_observation
from singulate.geometry import Push, Workspace


class DensityPolicy:
    """Pushes from where a density is highest, or draws from it.

    Attributes:
        network: Actor and critic.

    Args:
        config: The agent's settings.
        make_net: Builds its network from H, pixels along each side of an observation.
        env_config: The task.
        workspace: The table.
    """

    kind: str
    is_random = False

    def __init__(
        self,
        config: DensityPPOConfig,
        make_net: Callable[[int], TurnedNet],
        env_config: EnvConfig,
        workspace: Workspace,
    ) -> None:
        self.observation = env_config.observation
        self.workspace = workspace
        self._encoding = PointActions(workspace)
        self.network = DensityActorCritic(
            make_observation(env_config.observation, workspace).space,
            self._encoding.space,
            lambda _: config.learning_rate,
            **actor_critic_arguments(make_net),
        ).eval()

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The push that the density's `mode` says; with `rng`, a drawn one."""
        distribution = self.push_distribution(observation)
        if rng is None:
            action = distribution.mode()
        else:
            uniform = rng.random((1, distribution.num_uniforms))
            action = distribution.action_at(torch.as_tensor(uniform, dtype=torch.float32))
        return self._encoding.decode(action[0].clamp(-1.0, 1.0).numpy())

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Expected total reward of pushing as the policy would; the same for every `push`."""
        picture = batch_of_one(observation, self.workspace.image_size)
        with torch.no_grad():
            value = self.network.predict_values(picture)
        return float(value[0, 0]) / REWARD_SCALE

    def start_density(self, observation: FloatMap) -> FloatMap:
        """Probability that a push starts in each image cell, float32 (H, W), summing to 1."""
        return self.push_distribution(observation).start_density(self.workspace.image_size)

    def push_distribution(self, observation: FloatMap) -> PointDistribution:
        """The distribution of pushes for an observation, float32 (H, W); a batch of one."""
        picture = batch_of_one(observation, self.workspace.image_size)
        with torch.no_grad():
            return self.network.get_distribution(picture)
