from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.autoencoder.network import Autoencoder
from singulate.agents.autoencoder.quality import reconstruct
from singulate.agents.autoencoder.storing import load_autoencoder, save_autoencoder
from singulate.checkpoints import Manifest, encode_tensors, save_checkpoint
from singulate.exceptions import CheckpointError


@pytest.fixture
def saved(tmp_path: Path, trained: Any) -> Path:
    return save_autoencoder(tmp_path / "ae", trained.network, AutoencoderConfig(), {})


def test_what_is_loaded_is_what_was_saved(saved: Path, trained: Any) -> None:
    loaded = load_autoencoder(saved)
    expected = reconstruct(trained.network, trained.unseen)
    assert np.array_equal(reconstruct(loaded, trained.unseen), expected)
    assert not loaded.training


def test_an_agent_is_no_autoencoder(tmp_path: Path) -> None:
    tensors = {"layer.weight": np.ones(3, np.float32)}
    save_checkpoint(tmp_path / "agent", tensors, Manifest("dqn", {}, {}, 1))
    with pytest.raises(CheckpointError, match=r"is an agent \(dqn\), not an autoencoder"):
        load_autoencoder(tmp_path / "agent")


def test_tensors_that_do_not_fit_are_named(tmp_path: Path, trained: Any) -> None:
    tensors = {name: value.numpy() for name, value in trained.network.state_dict().items()}
    tensors["encoder.code.bias"] = np.zeros(16, np.float32)
    save_checkpoint(tmp_path / "ae", tensors, Manifest("autoencoder", {}, {}, 1))
    with pytest.raises(CheckpointError, match=r"encoder\.code\.bias is float32\[16\], not"):
        load_autoencoder(tmp_path / "ae")


@pytest.mark.parametrize("damage", ["missing", "truncated", "swapped", "pickle"])
def test_damage_is_one_line(damage: str, saved: Path) -> None:
    weights = saved / "weights.safetensors"
    if damage == "missing":
        weights.unlink()
    elif damage == "truncated":
        weights.write_bytes(weights.read_bytes()[:-1])
    elif damage == "swapped":
        weights.write_bytes(encode_tensors({"x": np.zeros(3, np.float32)}))
    else:
        torch.save({"x": torch.zeros(3)}, weights)
    with pytest.raises(CheckpointError, match=r"weights\.safetensors") as info:
        load_autoencoder(saved)
    assert "\n" not in str(info.value)


def test_what_has_diverged_is_not_saved(tmp_path: Path) -> None:
    network = Autoencoder()
    with torch.no_grad():
        network.encoder.code.bias[0] = float("nan")
    with pytest.raises(CheckpointError, match="not finite"):
        save_autoencoder(tmp_path / "ae", network, AutoencoderConfig(), {})
    assert not (tmp_path / "ae").exists()
