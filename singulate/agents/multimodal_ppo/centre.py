"""The surest push of a distribution: the centre of its heaviest region."""

import math

import torch
from torch.nn.functional import conv2d

from singulate.agents.multimodal_ppo.distribution import PushDistribution
from singulate.agents.multimodal_ppo.turning import NUM_DIRECTIONS

BLUR = 0.14
"""Standard deviation of the blur, in units of l: 14 cm, less than a block. Found by trial on 500
scenes of ``random-3`` apart from all that are reported."""


def centre_of_density(distribution: PushDistribution, blur: float = BLUR) -> torch.Tensor:
    """Actions where the blurred density peaks, (batch, 3).

    A push's outcome depends on its start to the millimetre, so the middle of a region where pushes
    succeed is safer than its highest cell. The peak is looked for among cells and directions,
    blurred over cells; the start is the mean of the density around it, weighted by the same blur.

    Args:
        distribution: What to choose from.
        blur: Standard deviation of the blur, in units of l.
    """
    cells = distribution.cells
    probs = distribution.log_probs.exp()
    choices = torch.arange(probs.shape[1]).repeat(len(probs))
    rows = torch.arange(len(probs)).repeat_interleave(probs.shape[1])
    means = cells.to_action(choices, distribution.offsets(choices, row=rows).mean())
    means = means.view(len(probs), -1, 3)
    summed = torch.stack([probs, probs * means[..., 0], probs * means[..., 1]], dim=1)
    maps = summed.view(-1, 1, cells.num_cells, cells.num_cells)
    kernel = _gaussian(blur / (2.0 * cells.half_cell))
    blurred = conv2d(maps, kernel, padding=kernel.shape[-1] // 2).view(len(probs), 3, -1)
    choice = blurred[:, 0].argmax(dim=1)
    mass, x, y = blurred[torch.arange(len(probs)), :, choice].unbind(dim=1)
    c = (cells.direction_of(choice) + 0.5) * 2.0 / NUM_DIRECTIONS - 1.0
    return torch.stack([x / mass, y / mass, c], dim=1)


def _gaussian(deviation: float) -> torch.Tensor:
    """A kernel, (1, 1, n, n), that ends beyond one and a third standard deviations."""
    reach = max(1, math.ceil(deviation * 4.0 / 3.0 - 1e-9))
    along = torch.exp(-0.5 * (torch.arange(-reach, reach + 1) / deviation) ** 2)
    return (along[:, None] * along)[None, None]
