"""Where a multimodal policy starts its pushes (as the paper's Fig. 6), without sampling."""

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.multimodal_ppo.distribution import PushDistribution


def start_density(distribution: PushDistribution, image_size: int) -> npt.NDArray[np.float32]:
    """Probability of each image cell, directions summed over.

    Args:
        distribution: Of one observation.
        image_size: H, pixels along each side; a multiple of the policy's cells.

    Returns:
        float32 (H, H), row 0 at +y, summing to 1.
    """
    cells = distribution.cells.num_cells
    pixels = image_size // cells
    probs = distribution.log_probs[0].exp()
    choices = torch.arange(len(probs))
    masses = _pixel_masses(distribution, choices, pixels)
    within = masses[:, 1].flip(1).unsqueeze(2) * masses[:, 0].unsqueeze(1)
    by_choice = (probs[:, None, None] * within).view(-1, cells, cells, pixels, pixels).sum(dim=0)
    density = by_choice.permute(0, 2, 1, 3).reshape(image_size, image_size)
    return density.numpy().astype(np.float32)


def _pixel_masses(
    distribution: PushDistribution, choices: torch.Tensor, pixels: int
) -> torch.Tensor:
    """Mass of each choice's offset in each pixel of its cell, along x and y: (N, 2, pixels)."""
    offsets = distribution.offsets(choices, row=torch.zeros_like(choices))
    edges = torch.linspace(-1.0, 1.0, pixels + 1)
    below = torch.stack([offsets.cumulative(edge) for edge in edges], dim=-1)
    return below.diff(dim=-1)
