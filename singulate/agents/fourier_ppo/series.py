"""Cosine series on a square."""

import math

import torch


def cosine_basis(num_points: int, num_frequencies: int) -> torch.Tensor:
    """The first cosines at the middles of equal intervals, orthonormal over these points.

    Basis of the discrete cosine transform, type II (Ahmed, Natarajan and Rao, 1974). Cosines of
    half-waves need no periodic continuation, so opposite sides of the table have nothing to do with
    each other; across its edges the series is mirrored.

    Args:
        num_points: N.
        num_frequencies: M, at most N.

    Returns:
        (N, M): cos(pi m (n + 1/2) / N) times sqrt(2 / N), sqrt(1 / N) for m = 0.
    """
    middle = (torch.arange(num_points, dtype=torch.float64) + 0.5) / num_points
    frequency = torch.arange(num_frequencies, dtype=torch.float64)
    basis = torch.cos(math.pi * middle[:, None] * frequency) * math.sqrt(2.0 / num_points)
    basis[:, 0] /= math.sqrt(2.0)
    return basis.float()


def coefficients_of(values: torch.Tensor, num_frequencies: int) -> torch.Tensor:
    """The lowest coefficients of maps: their projection on the cosines.

    Args:
        values: (..., N, N).
        num_frequencies: M, at most N.

    Returns:
        (..., M, M), scaled by 1 / N so that a constant map has itself as its first coefficient.
    """
    basis = cosine_basis(values.shape[-1], num_frequencies)
    return basis.T @ values @ basis / values.shape[-1]


def series_at(coefficients: torch.Tensor, num_points: int) -> torch.Tensor:
    """Values of a series at the centres of a grid's cells; undoes `coefficients_of`.

    Args:
        coefficients: (..., M, M).
        num_points: N, cells along each side, at least M.

    Returns:
        (..., N, N).
    """
    basis = cosine_basis(num_points, coefficients.shape[-1])
    return basis @ coefficients @ basis.T * num_points
