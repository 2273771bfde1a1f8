import numpy as np
import pytest
import torch

from singulate.agents.mixture_ppo.distribution import GaussianMixture

NUM_COMPONENTS = 4


def _parameters(seed: int = 0) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    generator = torch.Generator().manual_seed(seed)
    shape = (1, NUM_COMPONENTS, 3)
    return (
        torch.randn(1, NUM_COMPONENTS, generator=generator),
        torch.rand(shape, generator=generator) * 1.6 - 0.8,
        torch.rand(shape, generator=generator) * 0.3 + 0.1,
    )


def _mixture(batch: int = 1, seed: int = 0) -> GaussianMixture:
    parameters = [each.expand(batch, *each.shape[1:]) for each in _parameters(seed)]
    return GaussianMixture().proba_distribution(*parameters)


def _grid(limit: float, num_points: int) -> tuple[torch.Tensor, float]:
    """Centres of the cells of a cube, (N, 3), and their volume."""
    edges = torch.linspace(-limit, limit, num_points + 1)
    along = (edges[1:] + edges[:-1]) / 2
    return torch.cartesian_prod(along, along, along), (2.0 * limit / num_points) ** 3


def test_densities_integrate_to_one_and_bound_the_entropy() -> None:
    points, volume = _grid(2.4, 64)
    log_prob = _mixture(len(points)).log_prob(points).double()
    density = log_prob.exp()
    assert float(density.sum() * volume) == pytest.approx(1.0, abs=1e-3)
    entropy = float(-(density * log_prob).sum() * volume)
    bound = float(_mixture().entropy())
    assert entropy - 0.3 < bound < entropy + 1e-3


def test_samples_have_the_densities_that_are_reported() -> None:
    """Pearson's chi-square over the cells of a coarse grid; what lies outside is a cell too."""
    torch.manual_seed(0)
    num_samples, coarse, fine = 40_000, 4, 12
    points, volume = _grid(1.2, coarse * fine)
    masses = _mixture(len(points)).log_prob(points).double().exp() * volume
    split = masses.view(coarse, fine, coarse, fine, coarse, fine).sum(dim=(1, 3, 5)).flatten()
    expected = np.append(split.numpy(), 1.0 - float(split.sum())) * num_samples
    cells = ((_mixture(num_samples).sample() + 1.2) / 2.4 * coarse).floor().long()
    is_inside = ((cells >= 0) & (cells < coarse)).all(dim=1)
    index = (cells[:, 0] * coarse + cells[:, 1]) * coarse + cells[:, 2]
    index = torch.where(is_inside, index, coarse**3)
    counts = np.bincount(index.numpy(), minlength=coarse**3 + 1)
    is_common = expected > 10.0
    statistic = ((counts - expected)[is_common] ** 2 / expected[is_common]).sum()
    freedom = int(is_common.sum())
    assert freedom > 20
    assert statistic < freedom + 5.0 * np.sqrt(2.0 * freedom)


def test_one_component_is_a_gaussian() -> None:
    _, mean, scale = _parameters()
    mean, scale = mean[:, :1], scale[:, :1]
    mixture = GaussianMixture().proba_distribution(torch.zeros(1, 1), mean, scale)
    gaussian = torch.distributions.Independent(torch.distributions.Normal(mean, scale), 1)
    action = torch.tensor([[0.3, -0.2, 0.6]])
    assert torch.allclose(mixture.log_prob(action), gaussian.log_prob(action[:, None])[:, 0])
    assert torch.allclose(mixture.entropy(), gaussian.entropy()[:, 0])
    assert torch.equal(mixture.mode(), mean[:, 0])


def test_the_mode_is_the_mean_of_the_densest_component() -> None:
    mixture = _mixture(seed=4)
    means = mixture.mean[0]
    mode = mixture.mode()
    assert (means == mode).all(dim=1).any()
    densities = [float(mixture.log_prob(mean[None])) for mean in means]
    assert float(mixture.log_prob(mode)) == pytest.approx(max(densities))
    assert max(densities) > min(densities) + 0.1


def test_starts_are_counted_where_clipping_moves_them() -> None:
    torch.manual_seed(1)
    density = _mixture().start_density(64)
    assert density.sum() == pytest.approx(1.0, abs=1e-4)
    starts = _mixture(40_000).sample()[:, :2].clamp(-1.0, 1.0).numpy()
    counts, _, _ = np.histogram2d(-starts[:, 1], starts[:, 0], bins=8, range=[[-1, 1]] * 2)
    expected = density.reshape(8, 8, 8, 8).sum(axis=(1, 3))
    assert np.abs(counts / len(starts) - expected).max() < 0.01


def test_a_uniform_draw_of_one_is_finite() -> None:
    for value in (0.0, 1.0 - 1e-7, 1.0):
        assert torch.isfinite(_mixture().action_at(torch.full((1, 4), value))).all()


def test_gradients_reach_all_parameters() -> None:
    parameters = [each.requires_grad_() for each in _parameters()]
    mixture = GaussianMixture().proba_distribution(*parameters)
    for value in (mixture.log_prob(torch.tensor([[0.1, 0.2, 5.0]])), mixture.entropy()):
        gradients = torch.autograd.grad(value.sum(), parameters, retain_graph=True)
        for gradient in gradients:
            assert torch.isfinite(gradient).all() and gradient.abs().sum() > 0
