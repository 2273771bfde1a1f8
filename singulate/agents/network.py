"""How an observation enters the paper's network."""

import gymnasium as gym
import torch
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor

from singulate.agents.frozen_encoder import FrozenEncoder

OBSERVATION_SCALES = {"distance_map": 1.0 / 16.0, "mask": 1.0}
"""Constant factor for each kind of observation: distances are in pixels, up to about 90, and a
network's first layer wants numbers around one."""


class ScaledFlatten(BaseFeaturesExtractor):
    """Flattens an (H, W) observation and multiplies it by a constant.

    Args:
        observation_space: Box of shape (H, W).
        scale: The constant.
    """

    def __init__(self, observation_space: gym.Space[object], scale: float) -> None:
        shape = observation_space.shape
        assert shape is not None
        super().__init__(observation_space, features_dim=int(shape[0] * shape[1]))
        self.scale = scale

    def forward(self, observations: torch.Tensor) -> torch.Tensor:
        """Map (batch, H, W) to (batch, H * W)."""
        return observations.flatten(start_dim=1) * self.scale


def policy_arguments(
    observation: str, adam_epsilon: float, encoder: str | None = None
) -> dict[str, object]:
    """Arguments of stable-baselines3's policies that all our agents share.

    Args:
        observation: Name of the observation (a key of `OBSERVATION_SCALES`).
        adam_epsilon: Adam's epsilon, which stable-baselines3 sets by agent. The fused
            implementation is five times faster on a CPU core.
        encoder: Where the encoder of an agent that sees a code is from; None for an agent that sees
            the observation itself. Its weights are not read here: see `fill_encoder`.
    """
    return {
        "activation_fn": torch.nn.ReLU,
        **_features_extractor(observation, is_coded=encoder is not None),
        "normalize_images": False,
        "optimizer_kwargs": {"eps": adam_epsilon, "fused": True},
    }


def _features_extractor(observation: str, is_coded: bool) -> dict[str, object]:
    if is_coded:
        return {"features_extractor_class": FrozenEncoder}
    return {
        "features_extractor_class": ScaledFlatten,
        "features_extractor_kwargs": {"scale": OBSERVATION_SCALES[observation]},
    }
