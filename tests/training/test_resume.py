import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from singulate.agents.registry import AGENTS
from singulate.exceptions import CheckpointError
from singulate.runs import RunDirectory, RunReader, read_status
from singulate.training.trainer import train
from singulate.training.training_state import STATE_FILE, TENSORS_FILE


@pytest.mark.parametrize("agent", AGENTS)
def test_a_run_continued_in_a_new_process_equals_one_that_never_stopped(
    agent: str, tmp_path: Path, make_config: Any
) -> None:
    straight, halved = tmp_path / "straight", tmp_path / "halved"
    train(make_config(agent, 96), straight)
    train(make_config(agent, 48), halved)
    command = [sys.executable, "-m", "singulate", "train", "--resume", str(halved), "--steps", "96"]
    subprocess.run(command, check=True, timeout=120)
    for name in ("weights.safetensors", TENSORS_FILE, STATE_FILE):
        expected = (RunDirectory(straight).checkpoint_path(96) / name).read_bytes()
        assert (RunDirectory(halved).checkpoint_path(96) / name).read_bytes() == expected, name
    pushes = [RunReader(path).pushes_since() for path in (straight, halved)]
    assert pushes[0] == pushes[1]
    assert len(pushes[0]) == 96


def test_pushes_after_the_checkpoint_are_forgotten(tmp_path: Path, make_config: Any) -> None:
    """As if the trainer had been killed between two checkpoints."""
    train(make_config("dqn", 50, checkpoint_every=20), tmp_path / "run")
    run = RunDirectory(tmp_path / "run")
    shutil.rmtree(run.checkpoint_path(50))
    train(make_config("dqn", 60, checkpoint_every=20), run.path, resume=True)
    reader = RunReader(run.path)
    assert [push.step for push in reader.pushes_since()] == list(range(1, 61))
    assert reader.generation() == 1


def test_a_run_killed_before_its_first_push_starts_over(tmp_path: Path, make_config: Any) -> None:
    config = make_config("dqn", 12)
    RunDirectory(tmp_path / "run").create(config.to_dict())
    result = train(config, tmp_path / "run", resume=True)
    assert result.progress.num_steps == 12


@pytest.mark.parametrize("loss", ["damaged", "removed"])
def test_a_run_without_an_intact_checkpoint_is_left_alone(
    loss: str, tmp_path: Path, make_config: Any
) -> None:
    run = RunDirectory(tmp_path / "run")
    train(make_config("dqn", 20), run.path)
    for weights in run.checkpoints_path.glob("*/weights.safetensors"):
        weights.write_bytes(b"") if loss == "damaged" else shutil.rmtree(weights.parent)
    before = run.config_path.read_bytes()
    with pytest.raises(CheckpointError, match="the 20 recorded pushes cannot be continued") as info:
        train(make_config("dqn", 40), run.path, resume=True)
    assert "\n" not in str(info.value)
    assert RunReader(run.path).count_pushes() == 20
    assert RunReader(run.path).generation() == 0
    assert run.config_path.read_bytes() == before
    assert read_status(run.path).state == "failed"
