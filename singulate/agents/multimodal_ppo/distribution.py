"""The distribution of pushes: p(cell, direction), then p(offset | cell, direction)."""

import math
from typing import Any, Self

import torch
from stable_baselines3.common.distributions import Distribution

from singulate.agents.multimodal_ppo.cells import PushCells
from singulate.agents.multimodal_ppo.truncated_normal import TruncatedNormal
from singulate.agents.multimodal_ppo.turning import sizes_to_table, vectors_to_table


class PushDistribution(Distribution):
    """Densities of pushes over (x / l, y / l, direction), exact.

    Every push belongs to one cell and one direction, so its density is p(cell, direction) times
    that of its offset, however many modes there are. Offsets are truncated normals, independent
    along and across the push given the cell and the direction.

    Attributes:
        log_probs: Of all choices, (batch, 4 * cells ** 2).

    Args:
        cells: The grid of cells.
    """

    def __init__(self, cells: PushCells) -> None:
        super().__init__()  # type: ignore[no-untyped-call]
        self.cells = cells

    def proba_distribution_net(self, *args: Any, **kwargs: Any) -> torch.nn.Module:
        """None of its own: the parameters come as maps from a convolutional network."""
        raise NotImplementedError

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

    def sample(self) -> torch.Tensor:
        """Drawn actions, (batch, 3)."""
        return self.action_at(torch.rand((len(self.log_probs), 3)))

    def action_at(self, uniform: torch.Tensor) -> torch.Tensor:
        """Actions, (batch, 3), that follow the distribution if `uniform` is uniform on [0, 1)^3.

        Args:
            uniform: (batch, 3): for the choice, and for the offset along x and y.
        """
        cumulative = self.log_probs.exp().cumsum(dim=1)
        drawn = uniform[:, :1] * cumulative[:, -1:]
        choice = torch.searchsorted(cumulative, drawn, right=True)[:, 0]
        choice = choice.clamp(max=cumulative.shape[1] - 1)
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

    def actions_from_params(self, *args: Any, **kwargs: Any) -> torch.Tensor:
        """Drawn actions for parameters, as `proba_distribution` takes them."""
        return self.proba_distribution(*args, **kwargs).sample()

    def log_prob_from_params(self, *args: Any, **kwargs: Any) -> tuple[torch.Tensor, torch.Tensor]:
        """Drawn actions for parameters, and their log-densities."""
        actions = self.actions_from_params(*args, **kwargs)
        return actions, self.log_prob(actions)
