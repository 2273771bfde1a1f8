from pathlib import Path

import numpy as np
import pytest
import torch
from gymnasium import spaces

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.network import CODE_SIZE, Autoencoder
from singulate.agents.autoencoder.scenes import draw_maps
from singulate.agents.autoencoder.storing import save_autoencoder
from singulate.agents.dqn.config import DQNConfig
from singulate.agents.dqn.policy import build_policy as build_dqn
from singulate.agents.frozen_encoder import FrozenEncoder, fill_encoder, load_encoder
from singulate.agents.ppo.config import PPOConfig
from singulate.agents.ppo.policy import build_policy as build_ppo
from singulate.envs import EnvConfig
from singulate.exceptions import CheckpointError

SPACE = spaces.Box(-1.0, 91.0, (64, 64), np.float32)


@pytest.fixture
def maps() -> torch.Tensor:
    return torch.from_numpy(draw_maps("random-2", 3, np.random.default_rng(0)))


def test_features_are_the_code_and_no_gradient_reaches_them(maps: torch.Tensor) -> None:
    extractor = FrozenEncoder(SPACE)
    features = extractor(maps)
    assert features.shape == (3, extractor.features_dim) == (3, CODE_SIZE)
    assert not features.requires_grad
    assert not any(weight.requires_grad for weight in extractor.parameters())


def test_an_encoder_is_copied_into_every_part_of_a_policy(maps: torch.Tensor) -> None:
    encoder = Autoencoder().encoder
    actor_critic = build_ppo(PPOConfig(encoder="elsewhere"), EnvConfig("fixed-2")).network
    fill_encoder(actor_critic, encoder)
    extractors = [m for m in actor_critic.modules() if isinstance(m, FrozenEncoder)]
    assert extractors
    for extractor in extractors:
        assert torch.equal(extractor(maps), encoder(maps))


def test_a_dqn_sees_nothing_but_the_code(maps: torch.Tensor) -> None:
    config = DQNConfig(encoder="elsewhere", net_arch=(8,))
    network = build_dqn(config, EnvConfig(action="grid")).network
    with torch.no_grad():
        whole = network(maps)
        (extractor,) = [m for m in network.modules() if isinstance(m, FrozenEncoder)]
        assert not torch.equal(whole[0], whole[1])
        extractor.encoder.code.weight.zero_()  # every scene has the same code now
        blind = network(maps)
    assert torch.equal(blind[0], blind[1])


def test_loading_takes_the_encoding_half(tmp_path: Path, maps: torch.Tensor) -> None:
    network = Autoencoder()
    save_autoencoder(tmp_path / "ae", network, AutoencoderConfig(), {})
    with torch.no_grad():
        assert torch.equal(load_encoder(str(tmp_path / "ae"))(maps), network.encoder(maps))
    with pytest.raises(CheckpointError, match="nowhere"):
        load_encoder("nowhere")
