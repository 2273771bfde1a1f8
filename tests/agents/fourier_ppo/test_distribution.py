import math

import numpy as np
import pytest
import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.agents.fourier_ppo.distribution import FourierDistribution

NUM_CELLS = 16
NUM_CHOICES = 4 * NUM_CELLS**2


def _coefficients(seed: int = 0) -> torch.Tensor:
    return torch.randn(1, 4, 5, 5, generator=torch.Generator().manual_seed(seed)) * 0.5


def _distribution(batch: int = 1, seed: int = 0) -> FourierDistribution:
    coefficients = _coefficients(seed).expand(batch, -1, -1, -1)
    return FourierDistribution(PushCells(NUM_CELLS)).proba_distribution(coefficients)


def _all_actions(per_cell: int) -> torch.Tensor:
    """A fine grid of all starts, in all directions: (4 * n * n, 3)."""
    edges = torch.linspace(-1, 1, NUM_CELLS * per_cell + 1)
    along = (edges[1:] + edges[:-1]) / 2
    c = torch.tensor([-0.75, -0.25, 0.25, 0.75])
    return torch.cartesian_prod(along, along, c)


def test_densities_integrate_to_one_and_give_the_entropy() -> None:
    actions = _all_actions(per_cell=3)
    area = (2.0 / (NUM_CELLS * 3)) ** 2
    log_prob = _distribution(len(actions)).log_prob(actions).double()
    assert float(log_prob.exp().sum() * area) == pytest.approx(1.0, abs=1e-4)
    entropy = -(log_prob.exp() * log_prob).sum() * area
    assert float(_distribution().entropy()) == pytest.approx(float(entropy), abs=1e-4)
    assert float(entropy) < math.log(16.0) - 0.3  # far from uniform


def test_the_logarithm_of_the_density_is_the_series() -> None:
    """Differences at the cells' centres, by cosines written out."""
    coefficients = _coefficients()[0].double()
    actions = _all_actions(per_cell=1)
    log_prob = _distribution(len(actions)).log_prob(actions).double()
    right, down = (actions[:, 0] + 1.0) / 2.0, (1.0 - actions[:, 1]) / 2.0
    direction = ((actions[:, 2] + 1.0) * 2.0).long()
    series = torch.zeros(len(actions)).double()
    for m in range(5):
        for n in range(5):
            height = math.sqrt(2.0 - (m == 0)) * math.sqrt(2.0 - (n == 0))
            wave = torch.cos(math.pi * m * down) * torch.cos(math.pi * n * right)
            series += coefficients[direction, m, n] * height * wave
    constants = log_prob - series
    assert float(constants.std()) < 1e-4
    assert float(series.std()) > 0.3


def test_a_constant_series_has_the_entropy_of_the_square() -> None:
    flat = FourierDistribution(PushCells(NUM_CELLS)).proba_distribution(torch.zeros(1, 4, 5, 5))
    assert float(flat.entropy()) == pytest.approx(math.log(4 * 4), abs=1e-4)
    log_prob = flat.log_prob(torch.tensor([[0.3, -0.9, 0.4]]))
    assert float(log_prob) == pytest.approx(-math.log(16), abs=1e-4)


def test_samples_have_the_densities_that_are_reported() -> None:
    """Pearson's chi-square over quarters of cells, which shows the place in a cell too."""
    torch.manual_seed(0)
    num_samples, distribution = 200_000, _distribution()
    actions = _distribution(num_samples).sample()
    assert actions.abs().max() <= 1.0
    choice, offset = distribution.cells.from_action(actions)
    quarter = (offset[:, 0] > 0).long() * 2 + (offset[:, 1] > 0).long()
    counts = np.bincount((choice * 4 + quarter).numpy(), minlength=4 * NUM_CHOICES)
    probs = distribution.log_probs[0].exp().double().numpy()
    expected = np.repeat(probs / probs.sum() / 4.0, 4) * num_samples
    is_common = expected > 10.0
    statistic = ((counts - expected)[is_common] ** 2 / expected[is_common]).sum()
    freedom = int(is_common.sum())
    assert freedom > 500
    assert statistic < freedom + 5.0 * np.sqrt(2.0 * freedom)


def test_a_uniform_draw_of_one_never_leaves_the_table() -> None:
    for value in (0.0, 1.0 - 1e-7, 1.0):
        action = _distribution().action_at(torch.full((1, 3), value))
        assert torch.isfinite(action).all() and action.abs().max() <= 1.0


def test_the_mode_is_the_centre_of_the_likeliest_cell() -> None:
    distribution = _distribution(seed=5)
    choice, offset = distribution.cells.from_action(distribution.mode())
    assert torch.equal(choice, distribution.log_probs.argmax(dim=1))
    assert offset.abs().max() < 1e-4


def test_starts_of_all_directions_are_summed_over() -> None:
    distribution = _distribution()
    density = distribution.start_density(64)
    assert density.dtype == np.float32 and density.sum() == pytest.approx(1.0, abs=1e-4)
    by_cell = distribution.log_probs[0].exp().view(4, NUM_CELLS, NUM_CELLS).sum(dim=0).numpy()
    assert density[8:12, 20:24] == pytest.approx(by_cell[2, 5] / 16.0, abs=1e-7)


def test_gradients_reach_all_coefficients_but_the_common_constant() -> None:
    coefficients = _coefficients().requires_grad_()
    distribution = FourierDistribution(PushCells(NUM_CELLS)).proba_distribution(coefficients)
    value = distribution.log_prob(torch.tensor([[0.1, 0.2, 0.3]])) + distribution.entropy()
    (gradient,) = torch.autograd.grad(value.sum(), coefficients)
    assert torch.isfinite(gradient).all()
    assert float(gradient[0, :, 0, 0].sum()) == pytest.approx(0.0, abs=1e-4)
    assert (gradient[0].abs().sum(dim=(1, 2)) > 0).all()
