import math

import numpy as np
import pytest
import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.agents.multimodal_ppo.distribution import PushDistribution

NUM_CELLS = 4
NUM_CHOICES = 4 * NUM_CELLS**2


def _distribution(batch: int = 1, seed: int = 0) -> PushDistribution:
    generator = torch.Generator().manual_seed(seed)
    shape = (batch, 2, NUM_CHOICES)
    return PushDistribution(PushCells(NUM_CELLS)).proba_distribution(
        2.0 * torch.randn(batch, NUM_CHOICES, generator=generator),
        torch.rand(shape, generator=generator) * 2 - 1,
        torch.rand(shape, generator=generator) * 0.8 + 0.2,
    )


def _all_actions(per_cell: int) -> torch.Tensor:
    """A fine grid of all starts, in all directions: (4 * n * n, 3)."""
    edges = torch.linspace(-1, 1, NUM_CELLS * per_cell + 1)
    along = (edges[1:] + edges[:-1]) / 2
    c = torch.tensor([-0.75, -0.25, 0.25, 0.75])
    return torch.cartesian_prod(along, along, c)


def test_densities_integrate_to_one_and_give_the_entropy() -> None:
    distribution = _distribution()
    actions = _all_actions(per_cell=60)
    area = (2.0 / (NUM_CELLS * 60)) ** 2
    log_prob = PushDistribution(distribution.cells).proba_distribution(
        distribution.log_probs.expand(len(actions), -1),
        distribution._location.expand(len(actions), -1, -1),
        distribution._scale.expand(len(actions), -1, -1),
    ).log_prob(actions)  # fmt: skip
    density = log_prob.double().exp()
    assert float(density.sum() * area) == pytest.approx(1.0, abs=1e-3)
    entropy = -(density * log_prob).sum() * area
    assert float(distribution.entropy()) == pytest.approx(float(entropy), abs=5e-3)


def test_a_uniform_policy_has_the_entropy_of_the_square() -> None:
    shape = (1, 2, NUM_CHOICES)
    distribution = PushDistribution(PushCells(NUM_CELLS)).proba_distribution(
        torch.zeros(1, NUM_CHOICES), torch.zeros(shape), torch.full(shape, 100.0)
    )
    assert float(distribution.entropy()) == pytest.approx(math.log(4 * 4), abs=1e-4)
    log_prob = distribution.log_prob(torch.tensor([[0.3, -0.9, 0.4]]))
    assert float(log_prob) == pytest.approx(-math.log(16), abs=1e-4)


def test_samples_have_the_densities_that_are_reported() -> None:
    """The mean of -log p over samples is the entropy; of 1 / p the volume of all pushes, 16."""
    torch.manual_seed(0)
    distribution = _distribution(batch=1, seed=3)
    many = PushDistribution(distribution.cells).proba_distribution(
        distribution.log_probs.expand(100_000, -1),
        distribution._location.expand(100_000, -1, -1),
        distribution._scale.expand(100_000, -1, -1),
    )
    actions = many.sample()
    assert actions.abs().max() <= 1.0
    log_prob = many.log_prob(actions)
    assert float(-log_prob.mean()) == pytest.approx(float(distribution.entropy()), abs=0.02)
    choice, _ = distribution.cells.from_action(actions)
    shares = np.bincount(choice.numpy(), minlength=NUM_CHOICES) / len(choice)
    assert np.abs(shares - distribution.log_probs[0].exp().numpy()).max() < 0.006


def test_a_uniform_draw_of_one_never_leaves_the_choices() -> None:
    distribution = _distribution()
    for value in (0.0, 1.0 - 1e-7, 1.0):
        actions = distribution.action_at(torch.full((1, 3), value))
        assert torch.isfinite(actions).all() and actions.abs().max() <= 1.0


def test_the_mode_is_in_the_likeliest_cell() -> None:
    distribution = _distribution(batch=7, seed=5)
    choice, offset = distribution.cells.from_action(distribution.mode())
    assert torch.equal(choice, distribution.log_probs.argmax(dim=1))
    assert torch.allclose(offset, distribution.offsets(choice).mean(), atol=1e-4)


def test_gradients_reach_all_parameters() -> None:
    logits = torch.zeros(2, NUM_CHOICES, requires_grad=True)
    location = torch.zeros(2, 2, NUM_CHOICES, requires_grad=True)
    scale = torch.full((2, 2, NUM_CHOICES), 0.5, requires_grad=True)
    distribution = PushDistribution(PushCells(NUM_CELLS)).proba_distribution(
        logits, location, scale
    )
    actions = torch.tensor([[0.1, 0.2, 0.3], [-0.4, 0.5, -0.6]])
    distribution.log_prob(actions).sum().backward()
    for parameter in (logits, location, scale):
        assert parameter.grad is not None
        assert torch.isfinite(parameter.grad).all() and parameter.grad.abs().sum() > 0
