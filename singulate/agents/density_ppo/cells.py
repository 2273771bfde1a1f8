"""Where a start lies: in which cell, and where in it."""

import torch

from singulate.agents.density_ppo.turning import NUM_DIRECTIONS

EDGE = 1e-4
"""Drawn starts keep this part of half a cell off its border, so that rounding to float32 cannot
carry one into the next cell."""


class PushCells:
    """Between actions (x / l, y / l, c) and (choice, offset).

    A choice is a direction and a cell, ``direction * cells ** 2 + row * cells + column``, row 0 at
    +y; an offset is a start's place in its cell, (x, y) from -1 to 1. Four equal bins of c are the
    directions (`PointActions`).

    Args:
        num_cells: Cells along each side of the workspace.
    """

    def __init__(self, num_cells: int) -> None:
        self.num_cells = num_cells

    @property
    def half_cell(self) -> float:
        """Half the side of a cell, in units of l."""
        return 1.0 / self.num_cells

    def direction_of(self, choice: torch.Tensor) -> torch.Tensor:
        """Directions of choices, int64 (...)."""
        return choice // self.num_cells**2

    def to_action(self, choice: torch.Tensor, offset: torch.Tensor) -> torch.Tensor:
        """Actions, (..., 3), with c in the middle of the direction's bin.

        Args:
            choice: int64 (...).
            offset: (..., 2).
        """
        direction, cell = self.direction_of(choice), choice % self.num_cells**2
        row, col = cell // self.num_cells, cell % self.num_cells
        kept = offset.clamp(EDGE - 1.0, 1.0 - EDGE)
        x = (2 * col + 1 + kept[..., 0]) * self.half_cell - 1.0
        y = 1.0 - (2 * row + 1 - kept[..., 1]) * self.half_cell
        return torch.stack([x, y, (direction + 0.5) / 2.0 - 1.0], dim=-1)

    def from_action(self, action: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """Choices, int64 (...), and offsets, (..., 2): the inverse of `to_action`.

        Args:
            action: (..., 3), from -1 to 1.
        """
        right, down = (action[..., 0] + 1.0) / 2.0, (1.0 - action[..., 1]) / 2.0
        col, row = self._index(right, self.num_cells), self._index(down, self.num_cells)
        direction = self._index((action[..., 2] + 1.0) / 2.0, NUM_DIRECTIONS)
        offset_x = right * 2 * self.num_cells - (2 * col + 1)
        offset_y = (2 * row + 1) - down * 2 * self.num_cells
        choice = (direction * self.num_cells + row) * self.num_cells + col
        return choice, torch.stack([offset_x, offset_y], dim=-1).clamp(-1.0, 1.0)

    @staticmethod
    def _index(share: torch.Tensor, count: int) -> torch.Tensor:
        return (share * count).long().clamp(0, count - 1)
