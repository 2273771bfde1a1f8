import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from singulate.agents.loading import load_policy
from singulate.exceptions import RunError
from singulate.runs import RunReader, read_status
from singulate.training.config import TrainingConfig
from singulate.training.launcher import TrainerProcess, start_trainer


@pytest.fixture
def launch() -> Iterator[Callable[[TrainingConfig | None, Path], TrainerProcess]]:
    """Starts trainers, none of which outlives its test."""
    started: list[TrainerProcess] = []

    def start(config: TrainingConfig | None, run_dir: Path) -> TrainerProcess:
        started.append(start_trainer(config, run_dir))
        return started[-1]

    yield start
    for trainer in started:
        trainer.process.kill()
        trainer.process.wait()


def test_importing_the_launcher_pulls_no_torch() -> None:
    modules = "singulate.training.launcher, singulate.training.config"
    code = f"import sys, {modules}\nprint(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    loaded = set(done.stdout.split())
    assert "singulate.training.launcher" in loaded, done.stderr
    assert not loaded & {"torch", "stable_baselines3"}


def test_a_killed_trainer_is_explained_and_its_run_goes_on(
    tmp_path: Path, make_config: Any, launch: Any
) -> None:
    run_dir = tmp_path / "run"
    trainer = launch(make_config("dqn", 100_000, checkpoint_every=20), run_dir)
    assert os.getsid(trainer.process.pid) == trainer.process.pid
    assert os.getpriority(os.PRIO_PROCESS, trainer.process.pid) == min(os.nice(0) + 5, 19)
    _wait_for_steps(trainer, 50, generation=0)
    assert trainer.death() is None
    trainer.process.kill()
    trainer.process.wait()
    assert "killed by signal 9" in (trainer.death() or "")
    status = read_status(run_dir)
    assert status.state == "died" and "killed?" in status.error
    assert load_policy(run_dir).kind == "dqn"

    again = launch(None, run_dir)
    _wait_for_steps(again, 80, generation=1)
    again.process.send_signal(signal.SIGTERM)
    assert again.process.wait(timeout=30) == 0
    assert read_status(run_dir).state == "stopped"
    steps = [push.step for push in RunReader(run_dir).pushes_since(limit=100_000)]
    assert steps == list(range(1, len(steps) + 1))


def test_a_trainer_that_cannot_start_says_why(
    tmp_path: Path, make_config: Any, launch: Any
) -> None:
    run_dir = tmp_path / "run"
    run_dir.mkdir()
    (run_dir / "holiday.jpg").touch()
    trainer = launch(make_config("dqn", 10), run_dir)
    assert trainer.process.wait(timeout=60) == 2
    assert "holiday.jpg" in (trainer.death() or "")


def test_only_a_run_can_be_continued(tmp_path: Path) -> None:
    with pytest.raises(RunError):
        start_trainer(None, tmp_path)


def _wait_for_steps(trainer: TrainerProcess, num_steps: int, generation: int) -> None:
    reader = RunReader(trainer.run_dir)
    deadline = time.monotonic() + 60.0
    while reader.last_step() < num_steps or reader.generation() != generation:
        assert trainer.death() is None
        assert time.monotonic() < deadline, "timed out"
        time.sleep(0.05)
    reader.close()
