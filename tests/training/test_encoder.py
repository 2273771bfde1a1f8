import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.network import Autoencoder
from singulate.agents.autoencoder.storing import load_autoencoder, save_autoencoder
from singulate.agents.loading import load_policy, tensors_of
from singulate.checkpoints import read_checkpoint
from singulate.envs import EnvConfig
from singulate.exceptions import CheckpointError, InvalidValueError
from singulate.runs import RunDirectory
from singulate.training.config import TrainingConfig
from singulate.training.trainer import train
from singulate.training.training_state import STATE_FILE, TENSORS_FILE

PREFIX = "features_extractor.encoder."


@pytest.fixture
def encoder(tmp_path: Path) -> Path:
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(0)
        network = Autoencoder()
    return save_autoencoder(tmp_path / "ae", network, AutoencoderConfig(), {})


def with_encoder(config: TrainingConfig, encoder: Path) -> TrainingConfig:
    values = config.to_dict()
    values["agent_config"]["encoder"] = str(encoder)
    return TrainingConfig.from_dict(values)


@pytest.mark.parametrize("agent", ["dqn", "ppo"])
def test_training_leaves_the_encoder_as_it_is_and_needs_its_file_once(
    agent: str, tmp_path: Path, make_config: Any, encoder: Path
) -> None:
    expected = tensors_of(load_autoencoder(encoder).encoder)
    straight, halved = tmp_path / "straight", tmp_path / "halved"
    train(with_encoder(make_config(agent, 64), encoder), straight)
    train(with_encoder(make_config(agent, 32), encoder), halved)
    shutil.rmtree(encoder)

    train(with_encoder(make_config(agent, 64), encoder), halved, resume=True)
    checkpoint = RunDirectory(straight).checkpoint_path(64)
    for name in ("weights.safetensors", TENSORS_FILE, STATE_FILE):
        continued = RunDirectory(halved).checkpoint_path(64) / name
        assert continued.read_bytes() == (checkpoint / name).read_bytes(), name

    first = read_checkpoint(RunDirectory(straight).checkpoint_path(0)).tensors
    last = read_checkpoint(checkpoint).tensors
    for name, values in expected.items():
        assert np.array_equal(last[PREFIX + name], values), name
    learnt = [name for name in last if not np.array_equal(last[name], first[name])]
    assert learnt and not any("encoder" in name for name in learnt)
    push = load_policy(straight).act(np.full((64, 64), 9.0, np.float32))
    assert np.isfinite(push.start).all()


def test_a_missing_encoder_leaves_no_run_behind(tmp_path: Path, make_config: Any) -> None:
    config = with_encoder(make_config("ppo", 32), tmp_path / "nowhere")
    with pytest.raises(CheckpointError, match="nowhere"):
        train(config, tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_a_run_killed_before_its_first_push_still_needs_the_encoder(
    tmp_path: Path, make_config: Any, encoder: Path
) -> None:
    config = with_encoder(make_config("dqn", 12), encoder)
    RunDirectory(tmp_path / "run").create(config.to_dict())
    train(config, tmp_path / "run", resume=True)
    weights = read_checkpoint(RunDirectory(tmp_path / "run").checkpoint_path(12)).tensors
    expected = load_autoencoder(encoder).encoder.code.weight.detach().numpy()
    assert np.array_equal(weights[PREFIX + "code.weight"], expected)


@pytest.mark.parametrize("agent", ["dqn", "ppo"])
def test_settings_of_runs_without_an_encoder_are_as_they_always_were(
    agent: str, make_config: Any
) -> None:
    plain = make_config(agent, 10)
    assert "encoder" not in plain.agent_config
    values = plain.to_dict()
    values["agent_config"]["encoder"] = None
    assert TrainingConfig.from_dict(values) == plain


@pytest.mark.parametrize(
    ("agent", "observation", "value"),
    [("ppo", "mask", "ae"), ("ppo", "distance_map", 3), ("dqn", "distance_map", "")],
)
def test_an_encoder_that_makes_no_sense_is_refused(
    agent: str, observation: str, value: object
) -> None:
    action = "grid" if agent == "dqn" else "point"
    env = EnvConfig(observation=observation, action=action)
    with pytest.raises(InvalidValueError, match="encoder"):
        TrainingConfig(agent, env, 10, agent_config={"encoder": value})


def test_other_agents_have_no_encoder() -> None:
    with pytest.raises(InvalidValueError, match="encoder"):
        TrainingConfig("spatial", EnvConfig(), 10, agent_config={"encoder": "ae"})
