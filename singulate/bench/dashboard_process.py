"""The dashboard and a trainer as processes of their own, as a user runs them."""

import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NamedTuple

from singulate.envs import EnvConfig
from singulate.exceptions import RunError, SingulateError
from singulate.runs import log_tail, read_status
from singulate.training.config import TrainingConfig
from singulate.training.launcher import start_trainer

_START_TIMEOUT_S = 60.0
_POLL_S = 0.02
SCENARIO = "random-2"
WARM_UP_STEPS = 100


class RunningDashboard(NamedTuple):
    """A dashboard that listens.

    Attributes:
        url: Where.
        pid: Of its server; the other processes are its children.
    """

    url: str
    pid: int


@contextmanager
def running_dashboard(
    directory: Path, run_dir: Path | None = None, scenario: str = "fixed-2"
) -> Iterator[RunningDashboard]:
    """Start ``python -m app`` on a free port.

    Args:
        directory: For its log and for runs that it might start.
        run_dir: The run to watch.
        scenario: What stands on the table.

    Raises:
        SingulateError: If it ends before it listens.
    """
    arguments = ["app", "--port", "0", "--scenario", scenario]
    if run_dir is not None:
        arguments += ["--run", str(run_dir)]
    with _serving(arguments, directory) as dashboard:
        yield dashboard


@contextmanager
def running_bare_page(directory: Path) -> Iterator[str]:
    """Serve the least that a page can be; yields its URL. See `running_dashboard`."""
    with _serving(["app.bare_page"], directory) as page:
        yield page.url


@contextmanager
def _serving(arguments: Sequence[str], directory: Path) -> Iterator[RunningDashboard]:
    path = {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    log_path = directory / f"{arguments[0]}.log"
    with log_path.open("wb") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", *arguments],
            stdout=subprocess.PIPE,
            stderr=log,
            env=os.environ | path | {"SINGULATE_RUNS": str(directory)},
            text=True,
        )
    assert process.stdout is not None
    try:
        found = re.search(r"http\S+", process.stdout.readline())
        if found is None:
            said = log_path.read_text(errors="replace").strip().splitlines()[-1:]
            raise SingulateError(f"the dashboard does not start: {' '.join(said)}")
        yield RunningDashboard(found[0], process.pid)
    finally:
        process.terminate()
        process.stdout.close()
        try:
            process.wait(timeout=10.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


@contextmanager
def running_trainer(run_dir: Path) -> Iterator[None]:
    """Train a DQN in the background until the block ends; yields when it makes updates.

    It explores all the time, so that its pushes cost the same at any time.

    Raises:
        SingulateError: If the trainer does not come up.
    """
    config = TrainingConfig(
        agent="dqn",
        env=EnvConfig(scenario=SCENARIO, action="grid"),
        total_timesteps=10_000_000,
        agent_config={"learning_starts": WARM_UP_STEPS, "exploration_final_eps": 1.0},
    )
    trainer = start_trainer(config, run_dir)
    try:
        give_up = time.monotonic() + _START_TIMEOUT_S
        while _num_steps(run_dir) <= WARM_UP_STEPS:
            if trainer.process.poll() is not None or time.monotonic() > give_up:
                raise SingulateError(f"the trainer does not start: {' '.join(log_tail(run_dir))}")
            time.sleep(_POLL_S)
        yield
    finally:
        trainer.process.kill()
        trainer.process.wait()


def pushes_per_second(run_dir: Path, seconds: float) -> float:
    """Rate of a running training, measured between two of its own heartbeats.

    Raises:
        SingulateError: If the trainer has ended.
    """
    first = _next_beat(run_dir)
    time.sleep(seconds)
    last = _next_beat(run_dir)
    return (last[0] - first[0]) / (last[1] - first[1])


def _num_steps(run_dir: Path) -> int:
    """Steps done; 0 while there is no run yet."""
    with suppress(RunError):
        return read_status(run_dir).num_steps
    return 0


def _next_beat(run_dir: Path) -> tuple[int, float]:
    """(Steps, time [s]) as soon as the trainer writes them anew."""
    seen = read_status(run_dir).updated_at
    while (status := read_status(run_dir)).updated_at == seen:
        if not status.is_alive:
            raise SingulateError(f"the trainer has ended: {status.error or status.state}")
        time.sleep(_POLL_S)
    return status.num_steps, status.updated_at
