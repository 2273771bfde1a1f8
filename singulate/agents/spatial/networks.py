"""The network that learns and its running average, which acts."""

from collections.abc import Sequence
from copy import deepcopy

import numpy as np
import torch
from gymnasium import spaces
from stable_baselines3.common.policies import BasePolicy
from stable_baselines3.common.type_aliases import PyTorchObs, Schedule

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.choice import best_push
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.replay import as_distance_maps
from singulate.envs import PointActions
from singulate.geometry import Workspace


class SpatialNetworks(BasePolicy):
    """What stable-baselines3 calls a policy.

    Weights are averaged over updates because single updates on few pushes are noisy (Polyak and
    Juditsky 1992).

    Args:
        observation_space: Of the environment.
        action_space: ``point`` actions.
        lr_schedule: Its value at the beginning is Adam's first step size.
        net_arch: Channels of trunk and head.
        observation: Name of the observation.

    Attributes:
        learning: The network that learns.
        average: The network that acts.
        optimizer: Of `learning`.
    """

    def __init__(
        self,
        observation_space: spaces.Space[FloatMap],
        action_space: spaces.Space[FloatMap],
        lr_schedule: Schedule,
        *,
        net_arch: Sequence[int],
        observation: str,
    ) -> None:
        super().__init__(observation_space, action_space, normalize_images=False)
        trunk, head = net_arch
        self.learning = ValueNetwork(trunk, head)
        self.average = deepcopy(self.learning).requires_grad_(False)
        self.optimizer = torch.optim.Adam(
            self.learning.parameters(), lr=lr_schedule(1.0), fused=True
        )
        self._observation = observation
        self._workspace = Workspace()

    def follow(self, decay: float) -> None:
        """Move the average towards the weights that learn; it keeps a share `decay` of itself."""
        averaged, learnt = self.average.parameters(), self.learning.parameters()
        torch._foreach_lerp_(list(averaged), [p.data for p in learnt], 1.0 - decay)

    def _predict(self, observation: PyTorchObs, deterministic: bool = False) -> torch.Tensor:
        assert isinstance(observation, torch.Tensor)
        maps = as_distance_maps(observation.numpy(), self._observation)
        encoding = PointActions(self._workspace)
        pushes = [best_push(self.average, image, self._workspace) for image in maps]
        return torch.from_numpy(np.stack([encoding.encode(push) for push in pushes]))
