"""Runs with several environments: equal settings give equal runs, wherever the environments are."""

import random
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from singulate.agents.registry import AGENTS
from singulate.envs import EnvConfig
from singulate.runs import RunDirectory, RunReader
from singulate.training.config import TrainingConfig
from singulate.training.local_envs import LocalEnvs
from singulate.training.trainer import train
from singulate.training.training_state import STATE_FILE, TENSORS_FILE
from singulate.training.workers.env_worker import EnvWorker
from singulate.training.workers.messages import Answer
from singulate.training.workers.worker_envs import WorkerEnvs

FILES = ("weights.safetensors", TENSORS_FILE, STATE_FILE)


@pytest.mark.parametrize("agent", AGENTS)
def test_neither_workers_nor_their_timing_change_a_run(
    agent: str, tmp_path: Path, make_config: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    train(make_config(agent, 64, num_envs=2, num_workers=0), tmp_path / "here")
    monkeypatch.setattr(EnvWorker, "receive", _receive_late)
    train(make_config(agent, 64, num_envs=2, num_workers=2), tmp_path / "there")
    _assert_equal(tmp_path / "here", tmp_path / "there", 64)


@pytest.mark.parametrize("agent", AGENTS)
def test_a_continued_run_equals_one_that_never_stopped(
    agent: str, tmp_path: Path, make_config: Any
) -> None:
    straight, halved = tmp_path / "straight", tmp_path / "halved"
    train(make_config(agent, 96, num_envs=2), straight)
    train(make_config(agent, 48, num_envs=2), halved)
    command = [sys.executable, "-m", "singulate", "train", "--resume", str(halved), "--steps", "96"]
    subprocess.run(command, check=True, timeout=120)
    _assert_equal(straight, halved, 96)


def test_environments_share_out_the_episodes_and_the_schedule_of_a_run() -> None:
    """As if they pushed in turns: with one push an episode, push i is made in episode i."""
    env = EnvConfig("random-2", action="grid", reward="start_then_separation")
    config = TrainingConfig("dqn", env, 100, num_envs=3)
    envs = LocalEnvs(config)
    envs.reset()
    for _ in range(2):
        episodes = [info["episode_index"] for info in envs.step(np.array([0, 1, 2]))[3]]
    assert episodes == [3, 4, 5]
    assert [state.num_pushes for state in envs.states] == [6, 7, 8]
    envs.close()


def test_workers_load_no_torch() -> None:
    code = "import sys, singulate.training.workers.worker\nprint(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    loaded = set(done.stdout.split())
    assert "singulate.envs.push_env" in loaded
    assert not loaded & {"torch", "stable_baselines3"}


def test_the_middle_of_an_episode_is_restored_in_other_workers() -> None:
    env = EnvConfig("cluster-3", action="grid")
    config = TrainingConfig("dqn", env, 100, num_envs=2)
    one, other = WorkerEnvs(config, 1), WorkerEnvs(config, 2)
    one.reset()
    observations = one.step(np.array([145, 240]))[0]
    assert len(one.states[0].actions) == 1
    assert np.array_equal(other.restore(one.states), observations)
    following = [envs.step(np.array([240, 145]))[0] for envs in (one, other)]
    assert np.array_equal(*following)
    one.close()
    other.close()


def _receive_late(worker: EnvWorker) -> Answer:
    time.sleep(random.SystemRandom().random() * 0.01)
    return _receive(worker)


_receive = EnvWorker.receive


def _assert_equal(one: Path, other: Path, step: int) -> None:
    for name in FILES:
        files = [RunDirectory(run).checkpoint_path(step) / name for run in (one, other)]
        assert files[0].read_bytes() == files[1].read_bytes(), name
    pushes = [RunReader(run).pushes_since() for run in (one, other)]
    assert pushes[0] == pushes[1]
    assert len(pushes[0]) == step
