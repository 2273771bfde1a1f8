"""The distribution of pushes: p(cell, direction), then p(offset | cell, direction)."""

import math
from typing import Self

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.agents.density_ppo.distribution import PointDistribution, draw_index
from singulate.agents.density_ppo.turning import sizes_to_table, vectors_to_table
from singulate.agents.multimodal_ppo.truncated_normal import TruncatedNormal


class PushDistribution(PointDistribution):
    """Densities of pushes over (x / l, y / l, direction), exact.

    Every push belongs to one cell and one direction, so its density is p(cell, direction) times
    that of its offset, however many modes there are. Offsets are truncated normals, independent
    along and across the push given the cell and the direction.

    Attributes:
        log_probs: Of all choices, (batch, 4 * cells ** 2).

    Args:
        cells: The grid of cells.
    """

    num_uniforms = 3
    """For the choice, and for the offset along x and y."""

    def __init__(self, cells: PushCells) -> None:
        super().__init__()
        self.cells = cells

    @property
    def batch_size(self) -> int:
        """Scenes in the batch."""
        return len(self.log_probs)

    def proba_distribution(
        self, logits: torch.Tensor, location: torch.Tensor, scale: torch.Tensor
    ) -> Self:
        """Set the parameters.

        Args:
            logits: Of all choices, (batch, 4 * cells ** 2).
            location: Peaks of the offsets of all choices, (batch, 2, 4 * cells ** 2): right and
                up, as seen with the choice's direction pointing up.
            scale: Their standard deviations before the cut, of the same shape.
        """
        self.log_probs = torch.log_softmax(logits, dim=-1)
        self._location, self._scale = location, scale
        return self

    def log_prob(self, actions: torch.Tensor) -> torch.Tensor:
        """Log-densities of actions (batch, 3), per unit of x / l and y / l; (batch,)."""
        choice, offset = self.cells.from_action(actions)
        chosen = self.log_probs.gather(1, choice[:, None])[:, 0]
        along_axes = self.offsets(choice).log_prob(offset).sum(dim=-1)
        return chosen + along_axes - 2 * math.log(self.cells.half_cell)

    def entropy(self) -> torch.Tensor:
        """Differential entropy of (x / l, y / l, direction), (batch,)."""
        within = TruncatedNormal(self._location, self._scale).entropy().sum(dim=1)
        each = within + 2 * math.log(self.cells.half_cell) - self.log_probs
        return (self.log_probs.exp() * each).sum(dim=-1)

    def action_at(self, uniform: torch.Tensor) -> torch.Tensor:
        """See `PointDistribution.action_at`."""
        choice = draw_index(self.log_probs, uniform[:, 0])
        return self.cells.to_action(choice, self.offsets(choice).quantile(uniform[:, 1:]))

    def mode(self) -> torch.Tensor:
        """The likeliest cell and direction, and the mean start in it, (batch, 3)."""
        choice = self.log_probs.argmax(dim=1)
        return self.cells.to_action(choice, self.offsets(choice).mean())

    def offsets(self, choice: torch.Tensor, row: torch.Tensor | None = None) -> TruncatedNormal:
        """Distributions of the offsets (x, y) on the table given choices, (N, 2).

        Args:
            choice: int64 (N,).
            row: Whose choice each is, int64 (N,), index into the batch; one each by default.
        """
        row = torch.arange(len(choice)) if row is None else row
        direction = self.cells.direction_of(choice)
        return TruncatedNormal(
            vectors_to_table(self._location[row, :, choice], direction),
            sizes_to_table(self._scale[row, :, choice], direction),
        )

    def start_density(self, image_size: int) -> npt.NDArray[np.float32]:
        """See `PointDistribution.start_density`; `image_size` is a multiple of the cells."""
        cells, choices = self.cells.num_cells, torch.arange(self.log_probs.shape[1])
        pixels = image_size // cells
        masses = self._pixel_masses(choices, pixels)
        within = masses[:, 1].flip(1).unsqueeze(2) * masses[:, 0].unsqueeze(1)
        by_choice = self.log_probs[0].exp()[:, None, None] * within
        by_cell = by_choice.view(-1, cells, cells, pixels, pixels).sum(dim=0)
        density = by_cell.permute(0, 2, 1, 3).reshape(image_size, image_size)
        return density.numpy().astype(np.float32)

    def _pixel_masses(self, choices: torch.Tensor, pixels: int) -> torch.Tensor:
        """Mass of each choice's offset in each pixel of its cell, along x and y: (N, 2, pixels)."""
        offsets = self.offsets(choices, row=torch.zeros_like(choices))
        edges = torch.linspace(-1.0, 1.0, pixels + 1)
        below = torch.stack([offsets.cumulative(edge) for edge in edges], dim=-1)
        return below.diff(dim=-1)
