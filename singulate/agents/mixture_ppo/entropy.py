"""The entropy of a mixture of Gaussians has no closed form; a bound from below has."""

import math

import torch

_HALF_LOG_2_PI_E = 0.5 * math.log(2.0 * math.pi * math.e)


def entropy_lower_bound(
    log_weights: torch.Tensor, mean: torch.Tensor, scale: torch.Tensor
) -> torch.Tensor:
    """Lower bound of the differential entropy, by distances between pairs of components.

    H >= sum_i w_i H_i - sum_i w_i log sum_j w_j exp(-D_ij) with D the Bhattacharyya distance, the
    Chernoff divergence of alpha = 1/2 (Kolchinsky and Tracey, "Estimating mixture entropy with
    pairwise distances", Entropy 19(7), 2017). It is exact where components coincide and where they
    are far apart. A bonus on a lower bound is safe: raising it raises the entropy beneath which it
    lies or at least closes the gap, whereas an upper bound can grow without the entropy.

    Args:
        log_weights: Logarithms of the weights, (batch, K).
        mean: (batch, K, D).
        scale: Standard deviations along the axes, (batch, K, D).

    Returns:
        (batch,).
    """
    alone = (torch.log(scale) + _HALF_LOG_2_PI_E).sum(dim=-1)
    overlap = torch.logsumexp(log_weights[:, None] - bhattacharyya(mean, scale), dim=-1)
    return (log_weights.exp() * (alone - overlap)).sum(dim=-1)


def bhattacharyya(mean: torch.Tensor, scale: torch.Tensor) -> torch.Tensor:
    """Distances -log of the integral of sqrt(p_i p_j) between Gaussians with diagonal covariance.

    Formula: Bhattacharyya (1943); with variances s_i^2 and s_j^2 it is, summed over the axes,
    (m_i - m_j)^2 / (4 (s_i^2 + s_j^2)) + log((s_i^2 + s_j^2) / (2 s_i s_j)) / 2.

    Args:
        mean: (batch, K, D).
        scale: Standard deviations, (batch, K, D).

    Returns:
        (batch, K, K), 0 on the diagonal.
    """
    one, other = scale[:, :, None], scale[:, None]
    variances = one**2 + other**2
    apart = (mean[:, :, None] - mean[:, None]) ** 2 / (4.0 * variances)
    return (apart + 0.5 * torch.log(variances / (2.0 * one * other))).sum(dim=-1)
