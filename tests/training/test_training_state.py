import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from stable_baselines3.common.base_class import BaseAlgorithm

from singulate.checkpoints import decode_tensors, encode_tensors
from singulate.exceptions import CheckpointError
from singulate.training.envs import TrainingEnvs, make_training_envs
from singulate.training.model import build_training_model
from singulate.training.training_state import (
    STATE_FILE,
    TENSORS_FILE,
    capture_training,
    restore_training,
)

Training = tuple[BaseAlgorithm, TrainingEnvs, dict[str, bytes]]


@pytest.fixture
def training(make_config: Any) -> Iterator[Training]:
    config = make_config("dqn", 12)
    envs = make_training_envs(config)
    model = build_training_model(config, envs)
    model.learn(12)
    yield model, envs, capture_training(model, envs)
    envs.close()


def test_names_that_are_no_counters_are_not_set(training: Training) -> None:
    model, envs, files = training
    restore_training(model, envs, _with_counters(files, learn=1, gamma=7.0))
    assert callable(model.learn)
    assert model.gamma != 7.0  # type: ignore[attr-defined]
    assert model.num_timesteps == 12


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("num_timesteps", "12"),
        ("num_timesteps", 1.5),
        ("num_timesteps", -1),
        ("_n_updates", True),
        ("_n_calls", None),
        ("exploration_rate", float("nan")),
        ("exploration_rate", [0.5]),
    ],
)
def test_counters_are_numbers(training: Training, name: str, value: object) -> None:
    model, envs, files = training
    with pytest.raises(CheckpointError, match=f"does not fit: {name} is") as caught:
        restore_training(model, envs, _with_counters(files, **{name: value}))
    assert "\n" not in str(caught.value)


def test_what_belongs_to_no_network_has_to_fit(make_config: Any) -> None:
    config = make_config("sac", 12)
    envs = make_training_envs(config)
    model = build_training_model(config, envs)
    files = capture_training(model, envs)
    tensors = decode_tensors(files[TENSORS_FILE], TENSORS_FILE)
    assert tensors["extra.log_ent_coef"] == pytest.approx(np.log(0.1))
    files[TENSORS_FILE] = encode_tensors(tensors | {"extra.log_ent_coef": np.zeros(2, np.float32)})
    with pytest.raises(CheckpointError, match="does not fit"):
        restore_training(model, envs, files)
    envs.close()


def _with_counters(files: dict[str, bytes], **changes: object) -> dict[str, bytes]:
    values = json.loads(files[STATE_FILE])
    values["counters"].update(changes)
    return {**files, STATE_FILE: json.dumps(values).encode()}
