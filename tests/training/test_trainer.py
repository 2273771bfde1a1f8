import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from singulate.agents.loading import load_policy
from singulate.exceptions import RunError
from singulate.runs import RunDirectory, RunLock, RunReader, read_status, send_control
from singulate.training.links import Progress
from singulate.training.trainer import TrainingResult, train


def test_a_run_leaves_a_policy_a_record_and_event_files(tmp_path: Path, make_config: Any) -> None:
    result = train(make_config("dqn", 120, checkpoint_every=50), tmp_path / "run")
    assert result.state == read_status(result.run_dir).state == "finished"
    run = RunDirectory(result.run_dir)
    names = sorted(path.name for path in run.checkpoints_path.iterdir())
    assert names == [f"step-{step:09d}" for step in (0, 50, 100, 120)]
    assert list(run.tensorboard_path.glob("events.*"))
    reader = RunReader(run.path)
    assert reader.count_pushes() == 120
    expected = {
        "rollout/ep_rew_mean",
        "rollout/success_rate",
        "train/loss",
        "time/pushes_per_second",
    }
    assert expected <= set(reader.metric_names())
    push = reader.last_pushes(1)[0]
    assert push.predicted is not None
    assert set(push.terms) == {"start", "distance", "inside", "success"}
    observation = np.zeros((64, 64), dtype=np.float32)
    assert load_policy(run.path).act(observation) == load_policy(result.checkpoint).act(observation)


def test_a_checkpoint_knows_no_push_that_the_record_can_lose(
    tmp_path: Path, make_config: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("singulate.runs.record.COMMIT_INTERVAL_S", 3600.0)
    seen = []

    def look(progress: Progress) -> None:
        if progress.num_steps == 21:
            reader = RunReader(tmp_path / "run")
            seen.append(reader.last_step())
            reader.close()

    train(make_config("dqn", 22, checkpoint_every=20), tmp_path / "run", on_progress=look)
    assert seen == [20]


def test_old_checkpoints_are_removed(tmp_path: Path, make_config: Any) -> None:
    config = make_config("ppo", 64, checkpoint_every=16, num_checkpoints=2)
    result = train(config, tmp_path / "run")
    kept = sorted(path.name for path in result.checkpoint.parent.iterdir())
    assert kept == ["step-000000048", "step-000000064"]


@pytest.mark.parametrize("agent", ["ppo", "trpo"])
def test_gaussians_log_entropy_and_predict_by_value(
    agent: str, tmp_path: Path, make_config: Any
) -> None:
    train(make_config(agent, 112), tmp_path / "run")
    reader = RunReader(tmp_path / "run")
    entropy = reader.metrics_since("train/entropy").values
    assert np.isfinite(entropy).all() and len(entropy)
    assert reader.last_pushes(1)[0].predicted is not None


def test_a_directory_with_a_run_is_not_overwritten(tmp_path: Path, make_config: Any) -> None:
    train(make_config("dqn", 5), tmp_path / "run")
    with pytest.raises(RunError, match="holds a run already"):
        train(make_config("dqn", 5), tmp_path / "run")


def test_a_run_that_is_being_written_cannot_be_resumed(tmp_path: Path, make_config: Any) -> None:
    train(make_config("dqn", 5), tmp_path / "run")
    with RunLock(tmp_path / "run"), pytest.raises(RunError, match="in use by process"):
        train(make_config("dqn", 9), tmp_path / "run", resume=True)


@pytest.mark.parametrize("agent", ["dqn", "ppo"])
def test_pause_checkpoint_resume_and_stop(agent: str, tmp_path: Path, make_config: Any) -> None:
    run_dir = tmp_path / "run"
    trainer = _Background(make_config(agent, 100_000), run_dir)
    _wait(lambda: trainer.num_steps > 20)
    send_control(run_dir, "pause")
    _wait(lambda: read_status(run_dir).state == "paused")
    num_steps = trainer.num_steps
    time.sleep(0.3)
    assert trainer.num_steps == num_steps
    if agent == "dqn":
        send_control(run_dir, "checkpoint")
        _wait(RunDirectory(run_dir).checkpoint_path(num_steps).exists)
        assert read_status(run_dir).state == "paused"
    send_control(run_dir, "resume")
    _wait(lambda: trainer.num_steps > num_steps + 5)
    assert read_status(run_dir).state == "running"
    send_control(run_dir, "stop")
    result = trainer.result()
    assert result.state == read_status(run_dir).state == "stopped"
    assert result.checkpoint.name == f"step-{result.progress.num_steps:09d}"


def test_a_failure_is_written_down_in_one_line(tmp_path: Path, make_config: Any) -> None:
    def fail(progress: Progress) -> None:
        raise RuntimeError("the lamp\nwent out")

    with pytest.raises(RuntimeError):
        train(make_config("dqn", 50), tmp_path / "run", on_progress=fail)
    status = read_status(tmp_path / "run")
    assert status.state == "failed"
    assert status.error == "RuntimeError: the lamp went out"


class _Background:
    """A training in a thread of this process."""

    def __init__(self, config: Any, run_dir: Path) -> None:
        self.num_steps = 0
        self._results: list[TrainingResult] = []
        self._thread = threading.Thread(target=self._train, args=(config, run_dir), daemon=True)
        self._thread.start()

    def result(self) -> TrainingResult:
        self._thread.join(timeout=60)
        return self._results[0]

    def _train(self, config: Any, run_dir: Path) -> None:
        self._results.append(train(config, run_dir, on_progress=self._note))

    def _note(self, progress: Progress) -> None:
        self.num_steps = progress.num_steps


def _wait(condition: Callable[[], bool], timeout_s: float = 30.0) -> None:
    deadline = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < deadline, "timed out"
        time.sleep(0.02)
