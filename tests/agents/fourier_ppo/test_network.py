import pytest
import torch

from singulate.agents.fourier_ppo.config import HEAD_CELLS
from singulate.agents.fourier_ppo.network import FourierNet
from singulate.agents.fourier_ppo.series import series_at


def _net() -> FourierNet:
    torch.manual_seed(0)
    net = FourierNet(64, 64, 24, (8, 8))
    for parameter in net.parameters():  # far from the careful initialisation
        torch.nn.init.normal_(parameter, std=0.3)
    return net.eval()


def test_shapes() -> None:
    maps = _net()(torch.rand(3, 64, 64) * 60)
    assert maps.coefficients.shape == (3, 4, 24, 24)
    assert maps.values.shape == (3, 1)


def test_turning_the_table_turns_the_policy() -> None:
    """Densities of pushes turned along are equal, and so are values."""
    net, observation = _net(), torch.rand(1, 64, 64) * 60
    actions = torch.rand(500, 3) * 2 - 1
    x, y, c = actions.unbind(1)
    turned_actions = torch.stack([-y, x, torch.where(c < -0.5, c + 1.5, c - 0.5)], dim=1)
    with torch.no_grad():
        straight = net(observation.expand(500, -1, -1))
        turned = net(torch.rot90(observation, 1, (1, 2)).expand(500, -1, -1))
    before = straight.distribution().log_prob(actions)
    after = turned.distribution().log_prob(turned_actions)
    assert torch.allclose(before, after, atol=1e-3)
    assert before.std() > 0.1
    assert torch.allclose(straight.values, turned.values, atol=1e-4)


def test_an_untrained_policy_prefers_no_start() -> None:
    torch.manual_seed(0)
    maps = FourierNet(64, 64, 24, (16, 16, 16))(torch.rand(2, 64, 64) * 60)
    assert (maps.distribution().entropy() > 2.7).all()  # the largest is log 16 = 2.77


@pytest.mark.parametrize("num_frequencies", [8, 24, 32])
def test_a_peak_of_the_convolutions_keeps_its_height(num_frequencies: int) -> None:
    net = FourierNet(64, 64, num_frequencies, (8,))
    peak = torch.zeros(1, 4, 1, HEAD_CELLS, HEAD_CELLS)
    peak[0, 1, 0, 16, 12] = 3.0
    net.look = lambda _: (peak, torch.zeros(1, 1))  # type: ignore[assignment, method-assign]
    series = series_at(net(torch.zeros(1, 64, 64)).coefficients, HEAD_CELLS)
    turned_back = torch.rot90(peak[0, 1, 0], -1)
    at = divmod(int(turned_back.argmax()), HEAD_CELLS)
    assert float(series[0, 1][at]) == pytest.approx(3.0, rel=0.25)
