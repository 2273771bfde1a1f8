"""The network: what to choose, and where in each cell a start lies."""

import math
from typing import NamedTuple

import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.agents.density_ppo.network import TurnedNet
from singulate.agents.density_ppo.turning import turn_back
from singulate.agents.multimodal_ppo.distribution import PushDistribution

LOW_SCALE, HIGH_SCALE = 0.05, 1.5
"""Bounds of an offset's standard deviation, in halves of a cell: about 3 mm, and nearly uniform."""

RAW_SCALE = 0.8
"""What stands for the standard deviation of an untrained network: about 0.5 halves of a cell, small
enough for its peak to be felt."""

NUM_CHANNELS = 5
"""For each choice: its logit, and peak and deviation of the offset along both axes."""


class PushMaps(NamedTuple):
    """What the network says about a batch of scenes; choices as in `PushCells`.

    Attributes:
        cells: The grid of cells.
        logits: Of all choices, (batch, 4 * cells ** 2).
        location: Peaks of the offsets, (batch, 2, 4 * cells ** 2).
        scale: Their standard deviations before the cut, of the same shape.
        values: Expected (scaled) rewards, (batch, 1).
    """

    cells: PushCells
    logits: torch.Tensor
    location: torch.Tensor
    scale: torch.Tensor
    values: torch.Tensor

    def distribution(self) -> PushDistribution:
        """Densities of pushes."""
        return PushDistribution(self.cells).proba_distribution(
            self.logits, self.location, self.scale
        )


class PushNet(TurnedNet):
    """Says `PushMaps`.

    Args:
        image_size: H, pixels along each side of an observation.
        num_cells: Cells along each side; divides `image_size`.
        widths: Channels of the convolutions.
    """

    def __init__(self, image_size: int, num_cells: int, widths: tuple[int, ...]) -> None:
        super().__init__(image_size, num_cells, widths, NUM_CHANNELS)
        self._cells = PushCells(num_cells)

    def forward(self, observations: torch.Tensor) -> PushMaps:
        """Look at observations, (batch, H, H)."""
        heads, values = self.look(observations)
        by_choice = turn_back(heads).transpose(1, 2).flatten(2)
        return PushMaps(
            self._cells,
            by_choice[:, 0],
            torch.tanh(by_choice[:, 1:3]),
            _bounded_scale(by_choice[:, 3:]),
            values,
        )


def _bounded_scale(raw: torch.Tensor) -> torch.Tensor:
    low, high = math.log(LOW_SCALE), math.log(HIGH_SCALE)
    return torch.exp(low + (high - low) * torch.sigmoid(raw + RAW_SCALE))
