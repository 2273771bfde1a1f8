"""A mixture of Gaussians over (x / l, y / l, c)."""

import math
from typing import Self

import numpy as np
import numpy.typing as npt
import torch

from singulate.agents.density_ppo.distribution import PointDistribution, draw_index
from singulate.agents.gaussian.density import gaussian_start_density
from singulate.agents.mixture_ppo.entropy import entropy_lower_bound

_HALF_LOG_2_PI = 0.5 * math.log(2.0 * math.pi)
_SQRT_2 = math.sqrt(2.0)


class GaussianMixture(PointDistribution):
    """Sum of K Gaussians with diagonal covariance; its density is exact.

    As in the paper's PPO, a draw may lie outside the table and is clipped to it when it is pushed;
    densities are those of the draw before that.

    Attributes:
        log_weights: Logarithms of the weights, (batch, K).
        mean: (batch, K, 3).
        scale: Standard deviations, (batch, K, 3).
    """

    num_uniforms = 4
    """For the component, and for each coordinate."""

    @property
    def batch_size(self) -> int:
        """Scenes in the batch."""
        return len(self.log_weights)

    def proba_distribution(
        self, logits: torch.Tensor, mean: torch.Tensor, scale: torch.Tensor
    ) -> Self:
        """Set the parameters.

        Args:
            logits: Of the weights, (batch, K).
            mean: (batch, K, 3).
            scale: Standard deviations, (batch, K, 3).
        """
        self.log_weights = torch.log_softmax(logits, dim=-1)
        self.mean, self.scale = mean, scale
        return self

    def log_prob(self, actions: torch.Tensor) -> torch.Tensor:
        """Log-densities of actions (batch, 3) before clipping, (batch,)."""
        standard = (actions[:, None] - self.mean) / self.scale
        each = (-0.5 * standard**2 - torch.log(self.scale) - _HALF_LOG_2_PI).sum(dim=-1)
        return torch.logsumexp(self.log_weights + each, dim=-1)

    def entropy(self) -> torch.Tensor:
        """Lower bound of the differential entropy of (x / l, y / l, c), (batch,)."""
        return entropy_lower_bound(self.log_weights, self.mean, self.scale)

    def action_at(self, uniform: torch.Tensor) -> torch.Tensor:
        """See `PointDistribution.action_at`."""
        component = draw_index(self.log_weights, uniform[:, 0])
        row = torch.arange(self.batch_size)
        within = (2.0 * uniform[:, 1:] - 1.0).clamp(-0.9999999, 0.9999999)
        standard = _SQRT_2 * torch.erfinv(within)
        return self.mean[row, component] + self.scale[row, component] * standard

    def mode(self) -> torch.Tensor:
        """The mean of that component at which the mixture's density is highest, (batch, 3).

        A mixture's true modes have no closed form; they are near its components' means where these
        are apart.
        """
        means = self.mean.unbind(dim=1)
        densities = torch.stack([self.log_prob(mean) for mean in means], dim=1)
        return self.mean[torch.arange(self.batch_size), densities.argmax(dim=1)]

    def start_density(self, image_size: int) -> npt.NDArray[np.float32]:
        """See `PointDistribution.start_density`; what is clipped counts in the border's pixels."""
        weights = self.log_weights[0].exp().double().numpy()
        mean, scale = self.mean[0].double().numpy(), self.scale[0].double().numpy()
        density = np.zeros((image_size, image_size), dtype=np.float32)
        for weight, centre, deviation in zip(weights, mean, scale, strict=True):
            density += weight * gaussian_start_density(centre[:2], deviation[:2], image_size)
        return density
