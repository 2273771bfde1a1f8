"""Windows around the starts of pushes: all that an update needs, at a tenth of a picture's cost."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import AHEAD, ASIDE, BEHIND, BLOCK, pad
from singulate.agents.spatial.turning import Pixels

_HEIGHT, _WIDTH = AHEAD + BLOCK + BEHIND, ASIDE + BLOCK + ASIDE


class Windows(NamedTuple):
    """Parts of pictures for each of which the network gives one cell of 4 x 4 values.

    Attributes:
        canvases: float32 (N, height, width).
        pixels: Where the starts lie in the cells, float32 (N, 2), each within [0, 3].
    """

    canvases: FloatMap
    pixels: FloatMap


def cut_windows(maps: FloatMap, pixels: Pixels, rng: np.random.Generator | None) -> Windows:
    """Cut windows around starts.

    Args:
        maps: Distance maps, turned so that the pushes point up, float32 (N, H, W).
        pixels: Where the pushes start in them; starts beyond the outer pixel centres count as
            there.
        rng: Draws where in its cell each start lies, so that no place in it is favoured; in the
            middle without it.
    """
    size = np.array(maps.shape[1:])
    clipped = np.clip(pixels, 0, size - 1)
    corners = np.minimum(np.floor(clipped), size - 2).astype(np.int64)  # upper left of 4 neighbours
    in_cell = (1, 1) if rng is None else rng.integers(0, BLOCK - 1, size=corners.shape)
    corners = corners - np.asarray(in_cell)
    canvases = pad(maps, extra=BLOCK)
    views = np.lib.stride_tricks.sliding_window_view(canvases, (_HEIGHT, _WIDTH), axis=(1, 2))
    cut = views[np.arange(len(maps)), corners[:, 0] + BLOCK, corners[:, 1] + BLOCK]
    return Windows(cut, (clipped - corners).astype(np.float32))


def read_between(values: torch.Tensor, pixels: torch.Tensor) -> torch.Tensor:
    """Bilinear interpolation of maps, so that a value changes continuously with the start.

    Args:
        values: (N, h, w).
        pixels: (N, 2), each within [0, h - 1] and [0, w - 1].

    Returns:
        (N,).
    """
    limits = torch.tensor(values.shape[1:]) - 2
    corners = torch.minimum(pixels.floor().long(), limits)
    down, right = (pixels - corners).unbind(dim=1)
    row, col = corners.unbind(dim=1)
    each = torch.arange(len(values))
    upper = values[each, row, col] * (1 - right) + values[each, row, col + 1] * right
    lower = values[each, row + 1, col] * (1 - right) + values[each, row + 1, col + 1] * right
    return upper * (1 - down) + lower * down


def mirror_each(
    maps: FloatMap, pixels: Pixels, chosen: npt.NDArray[np.bool_]
) -> tuple[FloatMap, Pixels]:
    """Swap left and right in the chosen ones: the table behaves the same in a mirror.

    Args:
        maps: float32 (N, H, W).
        pixels: Starts in them, (N, 2).
        chosen: bool (N,).
    """
    maps, pixels = maps.copy(), pixels.copy()
    maps[chosen] = maps[chosen, :, ::-1]
    pixels[chosen, 1] = maps.shape[2] - 1 - pixels[chosen, 1]
    return maps, pixels
