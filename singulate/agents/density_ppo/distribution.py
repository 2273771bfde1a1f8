"""What distributions over ``point`` actions have in common."""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.common.distributions import Distribution


class PointDistribution(Distribution):
    """Densities of pushes for a batch of scenes.

    A subclass sets its parameters in `proba_distribution`, and has `log_prob`, `entropy` and
    `mode` too.

    Attributes:
        num_uniforms: Uniform numbers that decide a drawn push.
    """

    num_uniforms: int

    def __init__(self) -> None:
        super().__init__()  # type: ignore[no-untyped-call]

    @property
    def batch_size(self) -> int:
        """Scenes in the batch."""
        raise NotImplementedError

    def action_at(self, uniform: torch.Tensor) -> torch.Tensor:
        """Actions, (batch, 3), that follow the distribution if `uniform` is uniform on [0, 1).

        Args:
            uniform: (batch, num_uniforms).
        """
        raise NotImplementedError

    def start_density(self, image_size: int) -> npt.NDArray[np.float32]:
        """Where the pushes of the first scene start (as the paper's Fig. 6), without sampling.

        Args:
            image_size: H, pixels along each side of the table.

        Returns:
            Probability of each pixel, float32 (H, H), row 0 at +y, summing to 1.
        """
        raise NotImplementedError

    def sample(self) -> torch.Tensor:
        """Drawn actions, (batch, 3)."""
        return self.action_at(torch.rand((self.batch_size, self.num_uniforms)))

    def proba_distribution_net(self, *args: Any, **kwargs: Any) -> torch.nn.Module:
        """None of its own: the parameters come from a convolutional network."""
        raise NotImplementedError

    def actions_from_params(self, *args: Any, **kwargs: Any) -> torch.Tensor:
        """Drawn actions for parameters, as `proba_distribution` takes them."""
        distribution: PointDistribution = self.proba_distribution(*args, **kwargs)
        return distribution.sample()

    def log_prob_from_params(self, *args: Any, **kwargs: Any) -> tuple[torch.Tensor, torch.Tensor]:
        """Drawn actions for parameters, and their log-densities."""
        actions = self.actions_from_params(*args, **kwargs)
        return actions, self.log_prob(actions)


def draw_index(log_probs: torch.Tensor, uniform: torch.Tensor) -> torch.Tensor:
    """Indices that follow a categorical distribution, int64 (batch,).

    Args:
        log_probs: (batch, N).
        uniform: Uniform on [0, 1), (batch,).
    """
    cumulative = log_probs.exp().cumsum(dim=1)
    drawn = uniform[:, None] * cumulative[:, -1:]
    index = torch.searchsorted(cumulative, drawn, right=True)[:, 0]
    return index.clamp(max=cumulative.shape[1] - 1)
