"""A normal distribution cut off at -1 and 1, in closed form."""

import math

import torch

_SQRT_2 = math.sqrt(2.0)
_HALF_LOG_2_PI = 0.5 * math.log(2.0 * math.pi)


class TruncatedNormal:
    """Density proportional to that of N(location, scale) on [-1, 1], 0 elsewhere.

    With the location inside the interval, at least about half of the normal's mass is inside too
    where the scale is small, so nothing here loses its digits in float32.

    Formulas: Johnson, Kotz and Balakrishnan, "Continuous Univariate Distributions", vol. 1, ch. 13.

    Args:
        location: Peak of the density, in [-1, 1]; any shape.
        scale: Standard deviation before the cut, from about 0.01 to about 10; of the same shape.
    """

    def __init__(self, location: torch.Tensor, scale: torch.Tensor) -> None:
        self.location = location
        self.scale = scale
        self._low = (-1.0 - location) / scale
        self._high = (1.0 - location) / scale
        self._below = _cumulative(self._low)
        self._mass = _cumulative(self._high) - self._below

    def log_prob(self, value: torch.Tensor) -> torch.Tensor:
        """Logarithm of the density at values in [-1, 1], which are not checked."""
        standard = (value - self.location) / self.scale
        return _log_density(standard) - torch.log(self.scale * self._mass)

    def entropy(self) -> torch.Tensor:
        """Differential entropy; log 2 at most."""
        edges = self._high * _density(self._high) - self._low * _density(self._low)
        return 0.5 + _HALF_LOG_2_PI + torch.log(self.scale * self._mass) - edges / (2 * self._mass)

    def mean(self) -> torch.Tensor:
        """Expectation."""
        shift = (_density(self._low) - _density(self._high)) / self._mass
        return self.location + self.scale * shift

    def cumulative(self, value: torch.Tensor) -> torch.Tensor:
        """Probability of being below values in [-1, 1]."""
        standard = (value - self.location) / self.scale
        return (_cumulative(standard) - self._below) / self._mass

    def quantile(self, probability: torch.Tensor) -> torch.Tensor:
        """The inverse of `cumulative`; with uniform probabilities, a sample."""
        inside = self._below + probability * self._mass
        standard = _SQRT_2 * torch.erfinv((2.0 * inside - 1.0).clamp(-0.9999999, 0.9999999))
        return (self.location + self.scale * standard).clamp(-1.0, 1.0)


def _cumulative(standard: torch.Tensor) -> torch.Tensor:
    return 0.5 * torch.erfc(-standard / _SQRT_2)


def _log_density(standard: torch.Tensor) -> torch.Tensor:
    return -0.5 * standard**2 - _HALF_LOG_2_PI


def _density(standard: torch.Tensor) -> torch.Tensor:
    return torch.exp(_log_density(standard))
