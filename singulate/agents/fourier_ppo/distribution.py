"""The distribution of pushes: a cosine series for each direction is its logarithm."""

import math
from typing import Self

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.agents.density_ppo.distribution import PointDistribution, draw_index
from singulate.agents.density_ppo.turning import NUM_DIRECTIONS
from singulate.agents.fourier_ppo.series import series_at


class FourierDistribution(PointDistribution):
    """Densities of pushes over (x / l, y / l, direction), exact.

    log p(x, y, d) is a series in cosines, up to the constant that normalises it, taken at the
    centres of a fine grid's cells; within a cell the density is constant. A series for the
    logarithm needs no care to be positive, and few cosines give narrow peaks; the square of a
    series would be normalised by its coefficients alone, but has zeros, and at those the ratios of
    PPO are without bounds.

    Attributes:
        log_probs: Of all cells and directions (`PushCells`), (batch, 4 * cells ** 2).

    Args:
        cells: The grid.
    """

    num_uniforms = 3
    """For cell and direction, and for the place in the cell along x and y."""

    def __init__(self, cells: PushCells) -> None:
        super().__init__()
        self.cells = cells

    @property
    def batch_size(self) -> int:
        """Scenes in the batch."""
        return len(self.log_probs)

    def proba_distribution(self, coefficients: torch.Tensor) -> Self:
        """Set the parameters: coefficients by frequency along -y and x, (batch, 4, M, M)."""
        series = series_at(coefficients, self.cells.num_cells)
        self.log_probs = torch.log_softmax(series.flatten(1), dim=-1)
        return self

    def log_prob(self, actions: torch.Tensor) -> torch.Tensor:
        """Log-densities of actions (batch, 3), per unit of x / l and y / l; (batch,)."""
        choice, _ = self.cells.from_action(actions)
        return self.log_probs.gather(1, choice[:, None])[:, 0] - self._log_area

    def entropy(self) -> torch.Tensor:
        """Differential entropy of (x / l, y / l, direction), (batch,)."""
        return self._log_area - (self.log_probs.exp() * self.log_probs).sum(dim=-1)

    def action_at(self, uniform: torch.Tensor) -> torch.Tensor:
        """See `PointDistribution.action_at`."""
        choice = draw_index(self.log_probs, uniform[:, 0])
        return self.cells.to_action(choice, 2.0 * uniform[:, 1:] - 1.0)

    def mode(self) -> torch.Tensor:
        """The centre of the likeliest cell, and its direction, (batch, 3)."""
        choice = self.log_probs.argmax(dim=1)
        return self.cells.to_action(choice, torch.zeros(len(choice), 2))

    def start_density(self, image_size: int) -> npt.NDArray[np.float32]:
        """See `PointDistribution.start_density`; `image_size` is a multiple of the cells."""
        cells = self.cells.num_cells
        pixels = image_size // cells
        by_cell = self.log_probs[0].exp().view(NUM_DIRECTIONS, cells, cells).sum(dim=0)
        density = np.kron(by_cell.numpy(), np.full((pixels, pixels), 1.0 / pixels**2))
        return density.astype(np.float32)

    @property
    def _log_area(self) -> float:
        return 2.0 * math.log(2.0 * self.cells.half_cell)
