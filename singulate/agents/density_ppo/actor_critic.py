"""stable-baselines3's actor and critic, with our networks and distributions in it."""

from collections.abc import Callable
from typing import Any

import torch
from gymnasium import spaces
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.type_aliases import PyTorchObs, Schedule

from singulate.agents.density_ppo.distribution import PointDistribution
from singulate.agents.density_ppo.network import SceneMaps, TurnedNet


class DensityActorCritic(ActorCriticPolicy):
    """Actor and critic for ``point`` actions.

    Attributes:
        push_net: The network that both share.

    Args:
        observation_space: Box of shape (H, H).
        action_space: Box of shape (3,).
        lr_schedule: Learning rate as stable-baselines3 passes it.
        make_net: Builds the network from H.
        **kwargs: Further arguments of `ActorCriticPolicy`.
    """

    def __init__(
        self,
        observation_space: spaces.Space[Any],
        action_space: spaces.Space[Any],
        lr_schedule: Schedule,
        *,
        make_net: Callable[[int], TurnedNet],
        **kwargs: Any,
    ) -> None:
        self._make_net = make_net
        super().__init__(observation_space, action_space, lr_schedule, **kwargs)

    def _build(self, lr_schedule: Schedule) -> None:
        shape = self.observation_space.shape
        assert shape is not None
        self.push_net = self._make_net(shape[0])
        self.optimizer = torch.optim.Adam(
            self.parameters(), lr=lr_schedule(1), **self.optimizer_kwargs
        )

    def forward(
        self, obs: torch.Tensor, deterministic: bool = False
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """Actions (batch, 3), values (batch, 1) and log-densities (batch,)."""
        maps = self._look(obs)
        distribution = maps.distribution()
        actions = distribution.get_actions(deterministic=deterministic)
        return actions, maps.values, distribution.log_prob(actions)

    def evaluate_actions(
        self, obs: PyTorchObs, actions: torch.Tensor
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor | None]:
        """Values (batch, 1), log-densities (batch,) and entropies (batch,)."""
        maps = self._look(obs)
        distribution = maps.distribution()
        return maps.values, distribution.log_prob(actions), distribution.entropy()

    def get_distribution(self, obs: PyTorchObs) -> PointDistribution:
        """Distributions of pushes."""
        return self._look(obs).distribution()

    def predict_values(self, obs: PyTorchObs) -> torch.Tensor:
        """Values, (batch, 1)."""
        return self._look(obs).values

    def _look(self, obs: PyTorchObs) -> SceneMaps:
        maps: SceneMaps = self.push_net(obs)
        return maps
