import pytest
import torch

from singulate.agents.mixture_ppo.network import HIGH_SCALE, LOW_SCALE, MixtureNet


def _net(num_components: int = 8) -> MixtureNet:
    torch.manual_seed(0)
    net = MixtureNet(64, num_components, (8, 8))
    for parameter in net.parameters():  # far from the careful initialisation
        torch.nn.init.normal_(parameter, std=0.3)
    torch.nn.init.normal_(net.push_head.weight, std=2.0)
    return net.eval()


@pytest.mark.parametrize("num_components", [1, 6, 8])
def test_shapes_and_bounds(num_components: int) -> None:
    maps = _net(num_components)(torch.rand(3, 64, 64) * 60)
    assert maps.logits.shape == (3, num_components)
    assert maps.mean.shape == maps.scale.shape == (3, num_components, 3)
    assert maps.values.shape == (3, 1)
    assert maps.mean[..., :2].abs().max() <= 1.0
    assert maps.scale.min() >= LOW_SCALE - 1e-6
    assert maps.scale.max() <= HIGH_SCALE + 1e-6


def test_turning_the_table_turns_the_policy() -> None:
    """Each component goes on as the next of the four that share its weights."""
    net, observation = _net(), torch.rand(1, 64, 64) * 60
    with torch.no_grad():
        straight, turned = net(observation), net(torch.rot90(observation, 1, (1, 2)))
    after = torch.arange(8).view(2, 4).roll(1, dims=1).flatten()  # right becomes up
    x, y, _ = straight.mean[0].unbind(1)
    assert torch.allclose(turned.mean[0, after][:, :2], torch.stack([-y, x], 1), atol=1e-4)
    sizes = straight.scale[0][:, [1, 0, 2]]
    assert torch.allclose(turned.scale[0, after], sizes, atol=1e-4)
    assert torch.allclose(turned.logits[0, after], straight.logits[0], atol=1e-4)
    assert torch.allclose(straight.values, turned.values, atol=1e-4)
    assert straight.mean.std() > 0.1


def test_components_of_an_untrained_policy_cover_all_directions() -> None:
    torch.manual_seed(0)
    maps = MixtureNet(64, 8, (16, 16, 16))(torch.rand(2, 64, 64) * 60)
    middles = torch.tensor([-0.75, -0.25, 0.25, 0.75] * 2)
    assert torch.allclose(maps.mean[..., 2], middles.expand(2, -1), atol=0.05)
    weights = torch.softmax(maps.logits, dim=1)
    assert torch.allclose(weights, torch.full_like(weights, 1 / 8), atol=0.02)
    assert (maps.scale[..., :2] - 0.5).abs().max() < 0.05
