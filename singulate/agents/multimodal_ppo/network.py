"""The network: one look at the table for each direction, with the same weights."""

import math
from typing import NamedTuple

import torch
from stable_baselines3.common.policies import ActorCriticPolicy
from torch import nn

from singulate.agents.multimodal_ppo.turning import NUM_DIRECTIONS, turn_back, turn_images

DILATIONS = (2, 4, 2)
"""Of the 3 x 3 convolutions, in turns; three of them see 17 cells."""

LOW_SCALE, HIGH_SCALE = 0.05, 1.5
"""Bounds of an offset's standard deviation, in halves of a cell: about 3 mm, and nearly uniform."""

HALF_CLOSE_PX = 6.4
"""Distance at which an object is half close: 0.2 m, where r_Start peaks (Eq. 4)."""

RAW_SCALE = 0.8
"""What stands for the standard deviation of an untrained network: about 0.5 halves of a cell, small
enough for its peak to be felt."""

TRUNK_CELLS = 16
"""Cells along each side that the convolutions see; each may stand for several cells of the head."""

VALUE_WIDTH = 32
"""Hidden units of the value's head."""


class PushMaps(NamedTuple):
    """What the network says about a batch of scenes; choices as in `PushCells`.

    Attributes:
        logits: Of all choices, (batch, 4 * cells ** 2).
        location: Peaks of the offsets, (batch, 2, 4 * cells ** 2).
        scale: Their standard deviations before the cut, of the same shape.
        values: Expected (scaled) rewards, (batch, 1).
    """

    logits: torch.Tensor
    location: torch.Tensor
    scale: torch.Tensor
    values: torch.Tensor


class PushNet(nn.Module):
    """Fully convolutional trunk over cells, a head for pushes and one for the value.

    Args:
        image_size: H, pixels along each side of an observation.
        num_cells: Cells along each side; divides `image_size`.
        widths: Channels of the convolutions: one that goes from pixels to cells, then 3 x 3.
    """

    def __init__(self, image_size: int, num_cells: int, widths: tuple[int, ...]) -> None:
        super().__init__()
        trunk_cells = min(num_cells, TRUNK_CELLS)
        stride = image_size // trunk_cells
        layers: list[nn.Module] = [
            nn.Conv2d(2, widths[0], 2 * stride, stride=stride, padding=stride // 2),
            nn.ReLU(),
        ]
        channels = widths[0]
        for index, width in enumerate(widths[1:]):
            dilation = DILATIONS[index % len(DILATIONS)]
            layers += [nn.Conv2d(channels, width, 3, padding=dilation, dilation=dilation)]
            layers += [nn.ReLU()]
            channels = width
        self.trunk = nn.Sequential(*layers)
        fine = num_cells // trunk_cells
        self.push_head = nn.Conv2d(channels, 5 * fine**2, 1)
        self._to_cells = nn.PixelShuffle(fine)
        self.value_hidden = nn.Linear(2 * channels, VALUE_WIDTH)
        self.value_out = nn.Linear(VALUE_WIDTH, 1)
        self._initialise()

    def forward(self, observations: torch.Tensor) -> PushMaps:
        """Look at observations, (batch, H, H)."""
        batch = len(observations)
        images = turn_images(_channels(observations))
        features = self.trunk(images.flatten(0, 1))
        heads = self._to_cells(self.push_head(features))
        by_choice = turn_back(_by_scene(heads, batch)).transpose(1, 2).flatten(2)
        return PushMaps(
            by_choice[:, 0],
            torch.tanh(by_choice[:, 1:3]),
            _bounded_scale(by_choice[:, 3:]),
            self._values(_by_scene(features, batch)),
        )

    def _values(self, features: torch.Tensor) -> torch.Tensor:
        cells = features.transpose(1, 2).flatten(2)
        pooled = torch.cat([cells.mean(dim=2), cells.amax(dim=2)], dim=1)
        values: torch.Tensor = self.value_out(torch.relu(self.value_hidden(pooled)))
        return values

    def _initialise(self) -> None:
        """As stable-baselines3 does: orthogonal, and pushes nearly uniform at first."""
        for module in self.modules():
            gain = {self.push_head: 0.01, self.value_out: 1.0}.get(module, math.sqrt(2.0))
            ActorCriticPolicy.init_weights(module, gain)


def _channels(images: torch.Tensor) -> torch.Tensor:
    """Object, and closeness to one (1 at it, 0 far away), (N, 2, H, H); a mask has no distances."""
    closeness = HALF_CLOSE_PX / (images.clamp(min=0.0) + HALF_CLOSE_PX)
    return torch.stack([(images < 0.0).float(), closeness], dim=1)


def _by_scene(maps: torch.Tensor, batch: int) -> torch.Tensor:
    return maps.view(batch, NUM_DIRECTIONS, *maps.shape[1:])


def _bounded_scale(raw: torch.Tensor) -> torch.Tensor:
    low, high = math.log(LOW_SCALE), math.log(HIGH_SCALE)
    return torch.exp(low + (high - low) * torch.sigmoid(raw + RAW_SCALE))
