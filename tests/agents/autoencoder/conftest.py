from typing import NamedTuple

import numpy as np
import pytest

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.network import Autoencoder
from singulate.agents.autoencoder.scenes import Maps, draw_maps
from singulate.agents.autoencoder.training import train_autoencoder

SMALL = AutoencoderConfig(num_scenes=200, num_updates=200)


class Trained(NamedTuple):
    """A training and what it saw."""

    maps: Maps
    unseen: Maps
    network: Autoencoder
    losses: list[float]


@pytest.fixture(scope="session")
def trained() -> Trained:
    """A real training, if a short one."""
    maps = draw_maps(SMALL.scenario, SMALL.num_scenes, np.random.default_rng(0))
    unseen = draw_maps(SMALL.scenario, 100, np.random.default_rng(1))
    network, losses = train_autoencoder(SMALL, maps, np.random.default_rng(2))
    return Trained(maps, unseen, network, losses)
