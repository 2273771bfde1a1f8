"""stable-baselines3's actor and critic, with our network and distribution in it."""

from typing import Any

import torch
from gymnasium import spaces
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.type_aliases import PyTorchObs, Schedule

from singulate.agents.multimodal_ppo.cells import PushCells
from singulate.agents.multimodal_ppo.distribution import PushDistribution
from singulate.agents.multimodal_ppo.network import PushMaps, PushNet


class PushActorCritic(ActorCriticPolicy):
    """Actor and critic for ``point`` actions.

    Attributes:
        cells: The grid of cells.
        push_net: The network that both share.

    Args:
        observation_space: Box of shape (H, H).
        action_space: Box of shape (3,).
        lr_schedule: Learning rate as stable-baselines3 passes it.
        num_cells: Cells along each side.
        widths: Channels of the convolutions.
        **kwargs: Further arguments of `ActorCriticPolicy`.
    """

    def __init__(
        self,
        observation_space: spaces.Space[Any],
        action_space: spaces.Space[Any],
        lr_schedule: Schedule,
        *,
        num_cells: int,
        widths: tuple[int, ...],
        **kwargs: Any,
    ) -> None:
        self.cells = PushCells(num_cells)
        self._widths = widths
        super().__init__(observation_space, action_space, lr_schedule, **kwargs)

    def _build(self, lr_schedule: Schedule) -> None:
        shape = self.observation_space.shape
        assert shape is not None
        self.push_net = PushNet(shape[0], self.cells.num_cells, self._widths)
        self.optimizer = torch.optim.Adam(
            self.parameters(), lr=lr_schedule(1), **self.optimizer_kwargs
        )

    def forward(
        self, obs: torch.Tensor, deterministic: bool = False
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """Actions (batch, 3), values (batch, 1) and log-densities (batch,)."""
        maps: PushMaps = self.push_net(obs)
        distribution = self._distribution(maps)
        actions = distribution.get_actions(deterministic=deterministic)
        return actions, maps.values, distribution.log_prob(actions)

    def evaluate_actions(
        self, obs: PyTorchObs, actions: torch.Tensor
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor | None]:
        """Values (batch, 1), log-densities (batch,) and entropies (batch,)."""
        maps: PushMaps = self.push_net(obs)
        distribution = self._distribution(maps)
        return maps.values, distribution.log_prob(actions), distribution.entropy()

    def get_distribution(self, obs: PyTorchObs) -> PushDistribution:
        """Distributions of pushes."""
        return self._distribution(self.push_net(obs))

    def predict_values(self, obs: PyTorchObs) -> torch.Tensor:
        """Values, (batch, 1)."""
        maps: PushMaps = self.push_net(obs)
        return maps.values

    def _distribution(self, maps: PushMaps) -> PushDistribution:
        distribution = PushDistribution(self.cells)
        return distribution.proba_distribution(maps.logits, maps.location, maps.scale)
