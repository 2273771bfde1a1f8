"""The network: from what lies around a start to what a push upwards from there is worth."""

import numpy as np
import torch
from torch import nn

from singulate.agents.closeness import closeness
from singulate.agents.policy import FloatMap

BLOCK = 4
"""Pixels along each side of the cells in which the trunk works."""
AHEAD, BEHIND, ASIDE = 6 * BLOCK, 2 * BLOCK, 4 * BLOCK
"""How far the network sees around a cell, along the push and across it [px]. A push covers 16 px,
and a block that it moves may meet others behind that."""

_OFF_TABLE = -99.0


class ValueNetwork(nn.Module):
    """Values of pushes upwards, for every pixel of a picture at once.

    Only valid convolutions, so a value depends on its surroundings alone: the same wherever it
    stands in a picture, and the same in a window that is cut out for training as in the whole. The
    trunk works on cells of 4 x 4 pixels, and its head gives 16 values for each, one a pixel
    (sub-pixel convolution, Shi et al. 2016, arXiv 1609.05158): a fine map for the price of a coarse
    one.

    Args:
        trunk: Channels of the trunk.
        head: Channels of the head.
    """

    def __init__(self, trunk: int, head: int) -> None:
        super().__init__()
        self.layers = nn.Sequential(
            nn.PixelUnshuffle(BLOCK),
            *(nn.Conv2d(3 * BLOCK**2, trunk, 1), nn.ReLU()),
            *(nn.Conv2d(trunk, trunk, 3), nn.ReLU()),
            *(nn.Conv2d(trunk, trunk, 3, dilation=2), nn.ReLU()),
            *(nn.Conv2d(trunk, head, 3), nn.ReLU()),
            *(nn.Conv2d(head, head, 1), nn.ReLU()),
            nn.Conv2d(head, BLOCK**2, 1),
            nn.PixelShuffle(BLOCK),
        )

    def forward(self, canvases: torch.Tensor) -> torch.Tensor:
        """Scaled total reward that is expected.

        Args:
            canvases: Of `pad`, float32 (N, AHEAD + h + BEHIND, ASIDE + w + ASIDE), h and w
                multiples of `BLOCK`.

        Returns:
            float32 (N, h, w).
        """
        values: torch.Tensor = self.layers(_channels(canvases))[:, 0]
        return values


def pad(distance_maps: FloatMap, extra: int = 0) -> FloatMap:
    """Put distance maps, turned so that the push points up, onto canvases with room around them.

    Args:
        distance_maps: float32 (N, H, W) [px], -1 inside objects.
        extra: Further pixels on all sides.

    Returns:
        float32 (N, AHEAD + H + BEHIND + 2 extra, ASIDE + W + ASIDE + 2 extra); what lies off the
        table is marked.
    """
    around = ((0, 0), (AHEAD + extra, BEHIND + extra), (ASIDE + extra, ASIDE + extra))
    return np.pad(distance_maps, around, constant_values=_OFF_TABLE)


def _channels(canvases: torch.Tensor) -> torch.Tensor:
    """Object, closeness to one (1 at it, 0 far away) and off the table, (N, 3, h, w)."""
    is_off = canvases == _OFF_TABLE
    is_object = (canvases < 0.0) & ~is_off
    near = closeness(canvases) * ~is_off
    return torch.stack([is_object.float(), near, is_off.float()], dim=1)
