from typing import Any

import torch

from singulate.agents.autoencoder.network import (
    CODE_SIZE,
    Autoencoder,
    from_root,
    reconstruction_loss,
    to_root,
)


def test_roots_keep_what_is_inside_and_can_be_taken_back() -> None:
    maps = torch.tensor([-1.0, 1.0, 4.0, 81.0])
    assert to_root(maps).tolist() == [-1.0, 1.0, 2.0, 9.0]
    assert torch.equal(from_root(to_root(maps)), maps)


def test_a_map_becomes_a_few_numbers_and_a_map_again(trained: Any) -> None:
    maps = torch.from_numpy(trained.unseen[:3])
    network = Autoencoder()
    assert network.encoder(maps).shape == (3, CODE_SIZE)
    assert network(maps).shape == maps.shape


def test_standardising_the_code_changes_no_reconstruction(trained: Any) -> None:
    network, maps = Autoencoder(), torch.from_numpy(trained.maps)
    with torch.no_grad():
        before = network(maps[:8])
        network.standardise_code(maps)
        torch.testing.assert_close(network(maps[:8]), before, atol=1e-3, rtol=1e-3)


def test_a_wrong_mask_costs_more_than_the_error_that_it_makes() -> None:
    """Two reconstructions that are equally far off, one of them on the wrong side."""
    network, maps = Autoencoder(), torch.full((1, 64, 64), -1.0)
    losses = []
    with torch.no_grad():
        network.decoder.pixels.weight.zero_()
        for constant in (-3.0, 1.0):
            network.decoder.pixels.bias.fill_(constant)
            losses.append(reconstruction_loss(network, maps).item())
    assert losses[0] < losses[1]
