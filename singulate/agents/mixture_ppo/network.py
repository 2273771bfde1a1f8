"""The network: where each component of the mixture looks, and what it makes of it."""

import math
from typing import NamedTuple

import torch
from torch import nn

from singulate.agents.density_ppo.network import TRUNK_CELLS, TurnedNet
from singulate.agents.density_ppo.turning import (
    NUM_DIRECTIONS,
    sizes_to_table,
    vectors_to_table,
)
from singulate.agents.mixture_ppo.distribution import GaussianMixture

NUM_CHANNELS = 6
"""For each component: attention, weight, direction coordinate, and three deviations."""

LOW_SCALE, HIGH_SCALE = 0.02, 1.0
"""Bounds of a standard deviation, in units of l (2 cm) and of the direction coordinate."""

FIRST_SCALES = (0.5, 0.5, 0.2)
"""Standard deviations of an untrained network: starts all over the table, and a direction that
stays within its bin (0.25 to either side) in four of five draws."""

ATTENTION_GAIN = 1.0
"""Of the attention's initial weights, so that components differ from the beginning."""


class MixtureMaps(NamedTuple):
    """What the network says about a batch of scenes.

    Attributes:
        logits: Of the components' weights, (batch, K).
        mean: Of (x / l, y / l, c), (batch, K, 3).
        scale: Standard deviations, (batch, K, 3).
        values: Expected (scaled) rewards, (batch, 1).
    """

    logits: torch.Tensor
    mean: torch.Tensor
    scale: torch.Tensor
    values: torch.Tensor

    def distribution(self) -> GaussianMixture:
        """Densities of pushes."""
        return GaussianMixture().proba_distribution(self.logits, self.mean, self.scale)


class MixtureNet(TurnedNet):
    """Says `MixtureMaps`.

    Component k sees the table with direction k mod 4 pointing up. Its mean start is the expected
    place under a softmax over cells (spatial soft-argmax, Levine et al., "End-to-end training of
    deep visuomotor policies", JMLR 17, 2016, section 5.1), so it moves along with the blocks; its
    weight, its direction coordinate (at first the middle of that direction's bin) and its standard
    deviations are averages under the same softmax. Deviations come from the network, not from free
    parameters as in stable-baselines3: a component that stands at the blocks is to become narrow
    without one that has nothing to do in this scene becoming so too.

    Args:
        image_size: H, pixels along each side of an observation.
        num_components: K.
        widths: Channels of the convolutions.
    """

    def __init__(self, image_size: int, num_components: int, widths: tuple[int, ...]) -> None:
        per_direction = math.ceil(num_components / NUM_DIRECTIONS)
        super().__init__(image_size, TRUNK_CELLS, widths, NUM_CHANNELS * per_direction)
        self._num_components, self._per_direction = num_components, per_direction
        with torch.no_grad():
            attention = self.push_head.weight.view(self._per_direction, NUM_CHANNELS, -1)[:, 0]
            nn.init.orthogonal_(attention, ATTENTION_GAIN)

    def forward(self, observations: torch.Tensor) -> MixtureMaps:
        """Look at observations, (batch, H, H)."""
        heads, values = self.look(observations)
        shape = (len(heads), NUM_DIRECTIONS, self._per_direction, NUM_CHANNELS, -1)
        by_cell = heads.reshape(shape)
        attention = torch.softmax(by_cell[:, :, :, 0], dim=-1)
        pooled = (attention.unsqueeze(3) * by_cell[:, :, :, 1:]).sum(dim=-1)
        direction = torch.arange(NUM_DIRECTIONS)[:, None].expand(attention.shape[:3])
        start = vectors_to_table(attention @ _cell_centres(TRUNK_CELLS), direction)
        c = (direction + 0.5) / 2.0 - 1.0 + pooled[..., 1]
        scale = _bounded_scale(pooled[..., 2:])
        sizes = sizes_to_table(scale[..., :2], direction)
        return MixtureMaps(
            self._in_turns(pooled[..., 0]),
            self._in_turns(torch.cat([start, c.unsqueeze(-1)], dim=-1)),
            self._in_turns(torch.cat([sizes, scale[..., 2:]], dim=-1)),
            values,
        )

    def _in_turns(self, values: torch.Tensor) -> torch.Tensor:
        """From (batch, 4, per direction, ...) to (batch, K, ...)."""
        return values.transpose(1, 2).flatten(1, 2)[:, : self._num_components]


def _cell_centres(num_cells: int) -> torch.Tensor:
    """Centres of cells (right, up), from -1 to 1, (cells ** 2, 2)."""
    along = (2.0 * torch.arange(num_cells) + 1.0) / num_cells - 1.0
    up, right = torch.meshgrid(-along, along, indexing="ij")
    return torch.stack([right, up], dim=-1).flatten(0, 1)


def _bounded_scale(raw: torch.Tensor) -> torch.Tensor:
    low, high = math.log(LOW_SCALE), math.log(HIGH_SCALE)
    first = (torch.log(torch.tensor(FIRST_SCALES)) - low) / (high - low)
    return torch.exp(low + (high - low) * torch.sigmoid(raw + torch.logit(first)))
