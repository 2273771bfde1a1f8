"""Actor and critics, and what they are built from."""

import gymnasium as gym
import torch
from stable_baselines3.common.policies import BasePolicy, ContinuousCritic
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor
from stable_baselines3.sac.policies import SACPolicy
from stable_baselines3.td3.policies import TD3Policy

from singulate.agents.network import OBSERVATION_SCALES, policy_arguments

Networks = SACPolicy | TD3Policy
"""All networks of an agent, as stable-baselines3 keeps them."""


class FirstLayer(BaseFeaturesExtractor):
    """The first layer of the paper's network, which sees the picture alone.

    Critics get the action beside its outputs, as DDPG's do (Lillicrap et al. 2015, section 7):
    among the 4,096 pixels themselves, three numbers are hardly noticed.

    Args:
        observation_space: Box of shape (H, W).
        scale: Factor for the observations.
        width: Outputs.
    """

    def __init__(self, observation_space: gym.Space[object], scale: float, width: int) -> None:
        shape = observation_space.shape
        assert shape is not None
        super().__init__(observation_space, features_dim=width)
        self.scale = scale
        self.linear = torch.nn.Linear(int(shape[0] * shape[1]), width)

    def forward(self, observations: torch.Tensor) -> torch.Tensor:
        """Map (batch, H, W) to (batch, width)."""
        return torch.relu(self.linear(observations.flatten(start_dim=1) * self.scale))


class ActorAndCritics(torch.nn.Module):
    """What a checkpoint holds of an agent: all but the targets, which only learning needs.

    Args:
        networks: All networks.

    Attributes:
        actor: What chooses pushes.
        critic: Two networks that judge them.
    """

    actor: BasePolicy
    critic: ContinuousCritic

    def __init__(self, networks: Networks) -> None:
        super().__init__()
        self.actor = networks.actor
        self.critic = networks.critic


def network_arguments(net_arch: tuple[int, ...], observation: str) -> dict[str, object]:
    """Arguments of stable-baselines3's policies of SAC and TD3.

    Args:
        net_arch: Widths of the fully connected layers, of the actor and of each critic; the critics
            share the first.
        observation: Name of the observation.
    """
    first, *others = net_arch
    return {
        **policy_arguments(observation, adam_epsilon=1e-8),
        "net_arch": others,
        "features_extractor_class": FirstLayer,
        "features_extractor_kwargs": {"scale": OBSERVATION_SCALES[observation], "width": first},
    }
