import numpy as np
import pytest

from singulate.agents.ppo.density import gaussian_start_density


def test_density_sums_to_one_and_peaks_at_the_mean() -> None:
    density = gaussian_start_density(np.array([0.5, -0.25]), np.array([0.1, 0.1]), 64)
    assert density.dtype == np.float32
    assert density.sum() == pytest.approx(1.0, abs=1e-5)
    row, col = np.unravel_index(density.argmax(), density.shape)
    assert (row, col) in {(39, 47), (39, 48), (40, 47), (40, 48)}


def test_starts_clipped_to_the_border_count_there() -> None:
    density = gaussian_start_density(np.array([5.0, 0.0]), np.array([0.1, 0.2]), 64)
    assert density[:, -1].sum() == pytest.approx(1.0, abs=1e-5)


def test_density_agrees_with_sampling() -> None:
    mean, deviation = np.array([0.3, 0.7]), np.array([0.4, 0.6])
    samples = np.random.default_rng(0).normal(mean, deviation, size=(200_000, 2)).clip(-1, 1)
    counts, _, _ = np.histogram2d(-samples[:, 1], samples[:, 0], bins=8, range=[[-1, 1]] * 2)
    density = gaussian_start_density(mean, deviation, 8)
    assert np.abs(counts / len(samples) - density).max() < 3e-3
