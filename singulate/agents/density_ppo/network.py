"""The network: one look at the table for each direction, with the same weights."""

import math
from typing import Protocol

import torch
from stable_baselines3.common.policies import ActorCriticPolicy
from torch import nn

from singulate.agents.closeness import closeness
from singulate.agents.density_ppo.distribution import PointDistribution
from singulate.agents.density_ppo.turning import NUM_DIRECTIONS, turn_images

DILATIONS = (2, 4, 2)
"""Of the 3 x 3 convolutions, in turns; three of them see 17 cells."""

TRUNK_CELLS = 16
"""Cells along each side that the convolutions see; each may stand for several cells of the head."""

VALUE_WIDTH = 32
"""Hidden units of the value's head."""


class SceneMaps(Protocol):
    """What a network says about a batch of scenes."""

    @property
    def values(self) -> torch.Tensor:
        """Expected (scaled) rewards, (batch, 1)."""
        ...

    def distribution(self) -> PointDistribution:
        """Densities of pushes."""
        ...


class TurnedNet(nn.Module):
    """Fully convolutional trunk over cells, a head for pushes and one for the value.

    A subclass has a `forward` that makes `SceneMaps` of what `look` says.

    Args:
        image_size: H, pixels along each side of an observation.
        num_cells: Cells of the push head along each side; divides `image_size`.
        widths: Channels of the convolutions: one that goes from pixels to cells, then 3 x 3.
        num_channels: Channels of the push head.
    """

    def __init__(
        self, image_size: int, num_cells: int, widths: tuple[int, ...], num_channels: int
    ) -> None:
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
        self.push_head = nn.Conv2d(channels, num_channels * fine**2, 1)
        self._to_cells = nn.PixelShuffle(fine)
        self.value_hidden = nn.Linear(2 * channels, VALUE_WIDTH)
        self.value_out = nn.Linear(VALUE_WIDTH, 1)
        self._initialise()

    def look(self, observations: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """Look at a batch of scenes.

        Args:
            observations: (batch, H, H).

        Returns:
            The push head's maps, (batch, 4, num_channels, cells, cells), as seen with each
            direction pointing up, and the values, (batch, 1).
        """
        batch = len(observations)
        images = turn_images(_channels(observations))
        features = self.trunk(images.flatten(0, 1))
        heads = self._to_cells(self.push_head(features))
        return _by_scene(heads, batch), self._values(_by_scene(features, batch))

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
    return torch.stack([(images < 0.0).float(), closeness(images)], dim=1)


def _by_scene(maps: torch.Tensor, batch: int) -> torch.Tensor:
    return maps.view(batch, NUM_DIRECTIONS, *maps.shape[1:])
