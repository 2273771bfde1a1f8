"""An agent's first layers: the code of the distance map, from an encoder that stays as it is.

The encoder's weights are part of the agent's, so a checkpoint needs no other file. Environments,
replay memories and the page deal in maps, of which symmetries are known and which are small to
save; the code is made inside the network.
"""

from pathlib import Path

import gymnasium as gym
import torch
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor

from singulate.agents.autoencoder.network import CODE_SIZE, Encoder
from singulate.agents.autoencoder.storing import load_autoencoder


class FrozenEncoder(BaseFeaturesExtractor):
    """Codes distance maps; no gradient ever reaches its weights.

    Args:
        observation_space: Box of shape (64, 64).
    """

    def __init__(self, observation_space: gym.Space[object]) -> None:
        super().__init__(observation_space, features_dim=CODE_SIZE)
        self.encoder = Encoder().requires_grad_(False)

    def forward(self, observations: torch.Tensor) -> torch.Tensor:
        """Map (batch, 64, 64) [px] to (batch, CODE_SIZE)."""
        with torch.no_grad():
            code: torch.Tensor = self.encoder(observations)
        return code


def load_encoder(directory: str) -> Encoder:
    """The encoding half of an autoencoder.

    Raises:
        CheckpointError: If it is missing, damaged, or no autoencoder.
    """
    return load_autoencoder(Path(directory)).encoder


def fill_encoder(policy: torch.nn.Module, encoder: Encoder) -> None:
    """Copy an encoder into every `FrozenEncoder` of a policy, a target network's included."""
    for module in policy.modules():
        if isinstance(module, FrozenEncoder):
            module.encoder.load_state_dict(encoder.state_dict())
