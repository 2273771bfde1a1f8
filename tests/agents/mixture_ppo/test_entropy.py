import math

import pytest
import torch

from singulate.agents.mixture_ppo.entropy import bhattacharyya, entropy_lower_bound


def _mixture(seed: int, spread: float) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Logarithms of weights (1, 5), means and deviations (1, 5, 1)."""
    generator = torch.Generator().manual_seed(seed)
    logits = torch.randn(1, 5, generator=generator, dtype=torch.float64)
    mean = spread * torch.randn(1, 5, 1, generator=generator, dtype=torch.float64)
    scale = 0.2 + torch.rand(1, 5, 1, generator=generator, dtype=torch.float64)
    return torch.log_softmax(logits, dim=1), mean, scale


def _log_normal(x: torch.Tensor, mean: torch.Tensor, scale: torch.Tensor) -> torch.Tensor:
    return -0.5 * ((x - mean) / scale) ** 2 - torch.log(scale) - 0.5 * math.log(2 * math.pi)


def _entropy(log_weights: torch.Tensor, mean: torch.Tensor, scale: torch.Tensor) -> float:
    """By quadrature."""
    x = torch.linspace(-60, 60, 200_001, dtype=torch.float64)[:, None]
    log_prob = torch.logsumexp(log_weights + _log_normal(x, mean[..., 0], scale[..., 0]), dim=1)
    return float(-torch.trapezoid(log_prob.exp() * log_prob, x[:, 0]))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("spread", [0.1, 1.0, 5.0])
def test_it_is_below_the_entropy_and_not_far(seed: int, spread: float) -> None:
    parameters = _mixture(seed, spread)
    exact = _entropy(*parameters)
    bound = float(entropy_lower_bound(*parameters))
    assert exact - 0.3 < bound <= exact + 1e-6


def test_it_is_exact_for_one_gaussian_and_for_copies_of_it() -> None:
    log_weights, mean, scale = _mixture(0, 1.0)
    copies = (log_weights, mean[:, :1].expand_as(mean), scale[:, :1].expand_as(scale))
    expected = 0.5 * math.log(2 * math.pi * math.e) + math.log(float(scale[0, 0, 0]))
    assert float(entropy_lower_bound(*copies)) == pytest.approx(expected, abs=1e-9)
    one = (torch.zeros(1, 1).double(), mean[:, :1], scale[:, :1])
    assert float(entropy_lower_bound(*one)) == pytest.approx(expected, abs=1e-9)


def test_it_is_exact_for_components_far_apart() -> None:
    log_weights, _, scale = _mixture(1, 1.0)
    mean = torch.tensor([[-40.0, -20.0, 0.0, 20.0, 40.0]]).double()[..., None]
    parameters = (log_weights, mean, scale)
    exact = _entropy(*parameters)
    assert float(entropy_lower_bound(*parameters)) == pytest.approx(exact, abs=1e-6)


def test_distances_agree_with_quadrature() -> None:
    _, mean, scale = _mixture(2, 1.0)
    x = torch.linspace(-30, 30, 100_001, dtype=torch.float64)[:, None]
    log_normals = _log_normal(x, mean[..., 0], scale[..., 0])
    distances = bhattacharyya(mean, scale)[0]
    for i in range(5):
        for j in range(5):
            product = (0.5 * (log_normals[:, i] + log_normals[:, j])).exp()
            expected = -math.log(float(torch.trapezoid(product, x[:, 0])))
            assert float(distances[i, j]) == pytest.approx(expected, abs=1e-8)
