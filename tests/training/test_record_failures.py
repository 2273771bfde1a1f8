"""A record that cannot be written pauses a training; it neither ends it nor loses a row."""

import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from singulate.exceptions import RunError
from singulate.runs import RunDirectory, RunReader, read_status, send_control
from singulate.training.trainer import train


@pytest.mark.parametrize("agent", ["dqn", "ppo"])
def test_a_blocked_record_pauses_until_it_can_be_written(
    agent: str, tmp_path: Path, make_config: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("singulate.runs.record.LOCK_TIMEOUT_S", 0.1)
    run_dir = tmp_path / "run"
    told: list[str] = []
    training = _start(make_config(agent, 100_000), run_dir, on_trouble=told.append)
    _wait(lambda: RunReader(run_dir).last_step() > 20)
    with _blocked_record(run_dir):
        _wait(lambda: read_status(run_dir).state == "paused")
        assert "record.sqlite: cannot be written" in read_status(run_dir).error
        saved = RunDirectory(run_dir).latest_checkpoint()
        send_control(run_dir, "checkpoint")
        send_control(run_dir, "resume")
        time.sleep(1.0)
        _wait(lambda: read_status(run_dir).state == "paused")
        assert "record.sqlite: cannot be written" in read_status(run_dir).error
        assert RunDirectory(run_dir).latest_checkpoint() == saved
        assert read_status(run_dir).error in told
    paused_at = read_status(run_dir).num_steps
    send_control(run_dir, "resume")
    _wait(lambda: RunReader(run_dir).last_step() > paused_at + 5)
    assert read_status(run_dir).state == "running"
    send_control(run_dir, "stop")
    training.join(timeout=60)
    steps = [push.step for push in RunReader(run_dir).pushes_since(limit=100_000)]
    assert steps == list(range(1, len(steps) + 1))


def test_whoever_started_it_may_end_it_rather_than_wait(
    tmp_path: Path, make_config: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("singulate.runs.record.LOCK_TIMEOUT_S", 0.1)

    def give_up(reason: str) -> None:
        raise RunError(f"no room: {reason}")

    run_dir = tmp_path / "run"
    errors: list[RunError] = []
    training = _start(make_config("dqn", 100_000), run_dir, errors, give_up)
    _wait(lambda: RunReader(run_dir).last_step() > 5)
    with _blocked_record(run_dir):
        training.join(timeout=60)
    assert not training.is_alive()
    assert read_status(run_dir).state == "failed"
    assert "cannot be written" in str(errors[0])


def test_stopping_saves_the_checkpoint_even_if_the_record_is_blocked(
    tmp_path: Path, make_config: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("singulate.runs.record.LOCK_TIMEOUT_S", 0.1)
    run_dir = tmp_path / "run"
    errors: list[RunError] = []
    training = _start(make_config("dqn", 100_000), run_dir, errors)
    _wait(lambda: RunReader(run_dir).last_step() > 5)
    with _blocked_record(run_dir):
        _wait(lambda: read_status(run_dir).state == "paused")
        send_control(run_dir, "stop")
        training.join(timeout=60)
    status = read_status(run_dir)
    assert status.state == "stopped"
    assert "cannot be written" in status.error
    assert len(errors) == 1
    assert RunDirectory(run_dir).latest_checkpoint() == RunDirectory(run_dir).checkpoint_path(
        status.num_steps
    )


FULL_DISK = """
import resource, sys
from pathlib import Path
from singulate.training.event_files import EventFiles
soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
files = EventFiles(Path(sys.argv[1]), None)
resource.setrlimit(resource.RLIMIT_FSIZE, (2_000, hard))
for step in range(2_000):
    files.add(step, {"loss": 1.0})
resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
files.add(2_000, {"loss": 1.0})
files.close()
print("alive")
"""


def test_event_files_survive_a_full_disk(tmp_path: Path) -> None:
    command = [sys.executable, "-c", FULL_DISK, str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.stdout == "alive\n", done.stderr


def _start(
    config: Any,
    run_dir: Path,
    errors: list[RunError] | None = None,
    on_trouble: Callable[[str], None] | None = None,
) -> threading.Thread:
    def run() -> None:
        try:
            train(config, run_dir, on_trouble=on_trouble)
        except RunError as error:
            if errors is None:
                raise
            errors.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    return thread


@contextmanager
def _blocked_record(run_dir: Path) -> Iterator[None]:
    connection = sqlite3.connect(RunDirectory(run_dir).record_path, isolation_level=None)
    connection.execute("PRAGMA busy_timeout = 10000")
    connection.execute("BEGIN IMMEDIATE")
    try:
        yield
    finally:
        connection.execute("ROLLBACK")
        connection.close()


def _wait(condition: Callable[[], bool], timeout_s: float = 30.0) -> None:
    deadline = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < deadline, "timed out"
        time.sleep(0.02)
