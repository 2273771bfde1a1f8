import pytest
import torch

from singulate.agents.multimodal_ppo.truncated_normal import TruncatedNormal

CASES = [(0.0, 0.05), (0.9, 0.05), (-1.0, 0.3), (0.3, 0.7), (1.0, 1.5), (-0.2, 1.5)]


def _grid(num_points: int = 200_001) -> torch.Tensor:
    return torch.linspace(-1.0, 1.0, num_points, dtype=torch.float64)


def _normal(location: float, scale: float) -> TruncatedNormal:
    return TruncatedNormal(
        torch.tensor(location, dtype=torch.float64), torch.tensor(scale, dtype=torch.float64)
    )


@pytest.mark.parametrize(("location", "scale"), CASES)
def test_moments_agree_with_quadrature(location: float, scale: float) -> None:
    normal, x = _normal(location, scale), _grid()
    log_prob = normal.log_prob(x)
    density = log_prob.exp()
    assert torch.trapezoid(density, x).item() == pytest.approx(1.0, abs=1e-6)
    assert torch.trapezoid(density * x, x).item() == pytest.approx(normal.mean().item(), abs=1e-6)
    entropy = -torch.trapezoid(density * log_prob, x).item()
    assert normal.entropy().item() == pytest.approx(entropy, abs=1e-5)


@pytest.mark.parametrize(("location", "scale"), CASES)
def test_quantiles_invert_the_cumulative_distribution(location: float, scale: float) -> None:
    normal = _normal(location, scale)
    probability = torch.linspace(0.001, 0.999, 99, dtype=torch.float64)
    values = normal.quantile(probability)
    assert torch.allclose(normal.cumulative(values), probability, atol=1e-5)
    x = _grid(2001)
    slopes = normal.cumulative(x).diff() / x.diff()
    middle = normal.log_prob((x[1:] + x[:-1]) / 2).exp()
    assert torch.allclose(slopes, middle, rtol=1e-3, atol=1e-6)


def test_single_precision_holds_at_the_bounds() -> None:
    location = torch.tensor([-1.0, 0.0, 1.0, 1.0, -1.0])
    scale = torch.tensor([0.05, 0.05, 0.05, 1.5, 1.5])
    rough = TruncatedNormal(location, scale)
    exact = TruncatedNormal(location.double(), scale.double())
    for value in (-0.999, 0.0, 0.999):
        there = torch.full_like(location, value)
        assert torch.allclose(
            rough.log_prob(there).double(), exact.log_prob(there.double()), atol=1e-3
        )
    assert torch.allclose(rough.entropy().double(), exact.entropy(), atol=1e-5)
    assert rough.quantile(torch.tensor(0.0)).abs().max() <= 1.0
    assert torch.isfinite(rough.quantile(torch.tensor(1.0 - 1e-7))).all()


def test_gradients_stay_finite() -> None:
    location = torch.tensor([-1.0, 0.0, 1.0], requires_grad=True)
    scale = torch.tensor([0.05, 0.05, 1.5], requires_grad=True)
    normal = TruncatedNormal(location, scale)
    (normal.log_prob(torch.tensor([1.0, -1.0, 0.0])).sum() + normal.entropy().sum()).backward()
    assert location.grad is not None and torch.isfinite(location.grad).all()
    assert scale.grad is not None and torch.isfinite(scale.grad).all()
