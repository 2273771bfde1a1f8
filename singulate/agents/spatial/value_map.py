"""Predicted values of pushes for many starts, averaged over several views of the same scene."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import torch

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import AHEAD, ASIDE, BEHIND, BLOCK, ValueNetwork, pad
from singulate.agents.spatial.region import Region


@dataclass(frozen=True)
class View:
    """One way to look at a scene; what the network says should not depend on it.

    Attributes:
        is_mirrored: Whether left and right are swapped.
        shift: Pixels by which the grid of cells is moved, up and to the left; below `BLOCK`.
    """

    is_mirrored: bool = False
    shift: int = 0


ONE_VIEW = (View(),)
FOUR_VIEWS = tuple(View(is_mirrored, shift) for is_mirrored in (False, True) for shift in (0, 2))


def value_maps(
    network: ValueNetwork,
    turned: FloatMap,
    views: Sequence[View] = ONE_VIEW,
    regions: Iterable[Region] | None = None,
) -> FloatMap:
    """Scaled total reward that is expected of pushes upwards.

    Args:
        network: The network.
        turned: Distance maps, turned so that the pushes point up, float32 (N, H, H).
        views: What to average over.
        regions: The starts that matter in each map, all of one size; whole maps by default.

    Returns:
        float32 (N, height, width) of the regions.
    """
    size = turned.shape[1]
    chosen = list(regions) if regions is not None else [Region(0, 0, size, size)] * len(turned)
    height, width = chosen[0].height, chosen[0].width
    room = BLOCK if any(view.shift for view in views) else 0
    canvases = torch.from_numpy(pad(turned, extra=BLOCK))
    parts = [
        _seen(canvas, view, region, room)
        for view in views
        for canvas, region in zip(canvases, chosen, strict=True)
    ]
    with torch.no_grad():
        values = network(torch.stack(parts)).unflatten(0, (len(views), len(turned)))
    total = torch.zeros(len(turned), height, width)
    for view, seen in zip(views, values, strict=True):
        straight = seen.flip(2) if view.is_mirrored else seen
        total += straight[:, view.shift : view.shift + height, view.shift : view.shift + width]
    mean: FloatMap = (total / len(views)).numpy()
    return mean


def _seen(canvas: torch.Tensor, view: View, region: Region, room: int) -> torch.Tensor:
    """The part of a canvas that gives the values of a region, and of `room` pixels beyond."""
    top, left = region.row + BLOCK - view.shift, region.column + BLOCK - view.shift
    bottom = top + AHEAD + region.height + room + BEHIND
    right = left + ASIDE + region.width + room + ASIDE
    part = canvas[top:bottom, left:right]
    return part.flip(1) if view.is_mirrored else part
