"""What two critics expect of pushes."""

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.common.policies import ContinuousCritic

FloatArray = npt.NDArray[np.float32]


def lower_values(
    critic: ContinuousCritic, observations: torch.Tensor, actions: torch.Tensor
) -> torch.Tensor:
    """The lower of both critics' values of each pair, as in their targets, (batch,).

    Args:
        critic: The critics.
        observations: (batch, H, W).
        actions: (batch, dims).
    """
    return torch.cat(critic(observations, actions), dim=1).amin(dim=1)


def lower_values_of_one(
    critic: ContinuousCritic, picture: torch.Tensor, actions: FloatArray
) -> FloatArray:
    """`lower_values` of many actions on one observation, which is looked at only once.

    Args:
        critic: The critics.
        picture: The observation, float32 (1, H, H).
        actions: float32 (N, dims).

    Returns:
        float32 (N,).
    """
    with torch.no_grad():
        features = critic.extract_features(picture, critic.features_extractor)
        given = torch.as_tensor(actions)
        pairs = torch.cat([features.expand(len(given), -1), given], dim=1)
        found = torch.cat([network(pairs) for network in critic.q_networks], dim=1)
        values: FloatArray = found.amin(dim=1).numpy()
    return values
