"""A trained multimodal PPO, ready to push."""

import numpy as np
import torch

from singulate.agents.multimodal_ppo.actor_critic import PushActorCritic
from singulate.agents.multimodal_ppo.config import MultimodalPPOConfig
from singulate.agents.multimodal_ppo.density import start_density
from singulate.agents.multimodal_ppo.distribution import PushDistribution
from singulate.agents.multimodal_ppo.model import network_arguments
from singulate.agents.policy import FloatMap
from singulate.agents.reward_scale import REWARD_SCALE
from singulate.envs import EnvConfig, PointActions, make_observation
from singulate.geometry import Push, Workspace


class MultimodalPolicy:
    """Pushes from the likeliest cell, or draws from a density with many modes.

    The greedy push keeps to one cell: a mean over a region falls between two modes, such as the two
    sides of a seam, and there on the seam itself (96 % instead of 99 % on ``random-2``).

    Attributes:
        network: Actor and critic.
    """

    kind = "multimodal-ppo"
    is_random = False

    def __init__(
        self, config: MultimodalPPOConfig, env_config: EnvConfig, workspace: Workspace
    ) -> None:
        self.observation = env_config.observation
        self.workspace = workspace
        self._encoding = PointActions(workspace)
        self.network = PushActorCritic(
            make_observation(env_config.observation, workspace).space,
            self._encoding.space,
            lambda _: config.learning_rate,
            **network_arguments(config, env_config.observation),
        ).eval()

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The mean start in the likeliest cell and direction; with `rng`, a drawn push."""
        distribution = self.push_distribution(observation)
        if rng is None:
            action = distribution.mode()
        else:
            action = distribution.action_at(
                torch.as_tensor(rng.random((1, 3)), dtype=torch.float32)
            )
        return self._encoding.decode(action[0].clamp(-1.0, 1.0).numpy())

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Expected total reward of pushing as the policy would; the same for every `push`."""
        with torch.no_grad():
            value = self.network.predict_values(_batch(observation))
        return float(value[0, 0]) / REWARD_SCALE

    def start_density(self, observation: FloatMap) -> FloatMap:
        """Probability that a push starts in each image cell, float32 (H, W), summing to 1."""
        return start_density(self.push_distribution(observation), self.workspace.image_size)

    def push_distribution(self, observation: FloatMap) -> PushDistribution:
        """The distribution of pushes for an observation, float32 (H, W); a batch of one."""
        with torch.no_grad():
            return self.network.get_distribution(_batch(observation))


def _batch(observation: FloatMap) -> torch.Tensor:
    return torch.as_tensor(np.asarray(observation, dtype=np.float32)[None])


def build_policy(
    config: MultimodalPPOConfig, env_config: EnvConfig, workspace: Workspace | None = None
) -> MultimodalPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return MultimodalPolicy(config, env_config, workspace or Workspace())
