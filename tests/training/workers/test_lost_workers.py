"""Workers that are killed, stopped or hang in the middle of a training."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest

from singulate.envs import EnvConfig
from singulate.runs import RunReader, read_status
from singulate.training.episode_state import EpisodeState
from singulate.training.links import Progress
from singulate.training.session import TrainingSession
from singulate.training.trainer import TrainingResult, train
from singulate.training.workers.messages import Act, Acted, Restore, Settings
from singulate.training.workers.supervisor import Supervisor, WorkerError
from singulate.training.workers.worker_envs import WorkerEnvs

HANG_ON_SIGNAL = """
import signal, time
signal.signal(signal.SIGUSR1, lambda *_: time.sleep(3600))
"""


@dataclass
class Disturbance:
    """Sends a signal to a worker after a push, once."""

    number: signal.Signals
    after_step: int
    envs: list[WorkerEnvs]
    pid: int = 0
    blocked_s: float = 0.0
    sent_at: float = 0.0

    def __call__(self, progress: Progress) -> None:
        if not self.pid and progress.num_steps >= self.after_step:
            self.pid = self.envs[-1].pids[0]
            os.kill(self.pid, self.number)
            self.sent_at = time.monotonic()
        elif self.pid and not self.blocked_s and self.envs[-1].pids[0] != self.pid:
            self.blocked_s = time.monotonic() - self.sent_at


@pytest.fixture
def envs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[list[WorkerEnvs]]:
    """The environments of the trainings of a test, whose workers hang on SIGUSR1."""
    (tmp_path / "python").mkdir()
    (tmp_path / "python" / "sitecustomize.py").write_text(HANG_ON_SIGNAL)
    monkeypatch.syspath_prepend(str(tmp_path / "python"))
    monkeypatch.setattr("singulate.training.workers.watchdog.HANG_TIMEOUT_S", 2.0)
    seen: list[WorkerEnvs] = []

    def note(session: TrainingSession) -> None:
        if isinstance(session.envs, WorkerEnvs) and session.envs not in seen:
            seen.append(session.envs)
        at_safe_point(session)

    at_safe_point = TrainingSession.at_safe_point
    monkeypatch.setattr(TrainingSession, "at_safe_point", note)
    yield seen
    assert not any(_is_alive(pid) for one in seen for pid in one.pids)


@pytest.mark.parametrize(
    ("agent", "number"),
    [
        ("dqn", signal.SIGKILL),
        ("dqn", signal.SIGSTOP),
        ("dqn", signal.SIGUSR1),
        ("ppo", signal.SIGSTOP),
    ],
)
def test_a_lost_worker_is_replaced_its_episode_truncated_and_the_training_goes_on(
    agent: str, number: signal.Signals, tmp_path: Path, make_config: Any, envs: list[WorkerEnvs]
) -> None:
    disturbance = Disturbance(number, after_step=32, envs=envs)
    result = _train(make_config(agent, 96, num_envs=4, num_workers=2), tmp_path, disturbance)
    assert (result.state, result.progress.num_steps) == ("finished", 96)
    assert disturbance.pid not in envs[0].pids
    assert not _is_alive(disturbance.pid)
    assert 0.0 < disturbance.blocked_s < 10.0
    events = RunReader(result.run_dir).events_since()
    (lost,) = [event.detail for event in events if event.kind == "worker_replaced"]
    assert lost["pid"] == disturbance.pid
    pushes = RunReader(result.run_dir).pushes_since()
    assert [push.step for push in pushes] == list(range(1, 97))
    (truncated,) = [push for push in pushes if push.outcome == "simulation_error"]
    assert truncated.episode == lost["episode_index"]
    assert truncated is [push for push in pushes if push.episode == truncated.episode][-1]
    assert str(disturbance.pid) in read_status(result.run_dir).notice


def test_the_other_episodes_of_a_lost_worker_go_on_where_they_were(
    tmp_path: Path, make_config: Any, envs: list[WorkerEnvs]
) -> None:
    """All four live in the lost worker; learning starts late, so all actions stay the same."""
    config = make_config("dqn", 40, num_envs=4, num_workers=1, learning_starts=1000)
    calm = _train(config, tmp_path / "calm")
    disturbed = _train(config, tmp_path / "other", Disturbance(signal.SIGKILL, 12, envs))
    before, after = (RunReader(r.run_dir).pushes_since() for r in (calm, disturbed))
    (lost,) = [push for push in after if push.outcome == "simulation_error"]
    own = {push.step for push in after if push.step >= lost.step and push.step % 4 == lost.step % 4}
    assert [p for p in after if p.step not in own] == [p for p in before if p.step not in own]
    assert len(own) >= 5


def test_a_push_is_lost_once_even_if_its_second_worker_dies_too() -> None:
    states = [EpisodeState.initial(0, 1).after_reset()]
    supervisor = Supervisor(Settings(EnvConfig("fixed-2"), 0), states, num_workers=1)
    supervisor.request([Restore(0, states[0])])
    supervisor.gather()
    os.kill(supervisor.pids[0], signal.SIGKILL)
    supervisor.request([Act(0, [0.0, 0.0, 0.0])])
    threading.Thread(target=_kill_the_next, args=(supervisor, supervisor.pids[0])).start()
    (answer,) = supervisor.gather()
    supervisor.close()
    assert isinstance(answer, Acted) and answer.info["TimeLimit.truncated"]
    assert [loss.env_index for loss in supervisor.losses] == [0, None]


def test_a_fault_of_an_environment_is_told_in_one_line(make_config: Any) -> None:
    envs = WorkerEnvs(make_config("dqn", 10, num_envs=2), num_workers=1)
    envs.reset()
    with pytest.raises(WorkerError, match="InvalidValueError: action") as caught:
        envs.step(np.array([0, 400]))
    envs.close()
    assert "\n" not in str(caught.value)


ORPHANS = """
import os, signal
from singulate.envs import EnvConfig
from singulate.training.config import TrainingConfig
from singulate.training.workers.worker_envs import WorkerEnvs
envs = WorkerEnvs(TrainingConfig("ppo", EnvConfig("fixed-2"), 10, num_envs=2), 2)
envs.reset()
print(*envs.pids, flush=True)
os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the kernel's help is Linux's")
def test_workers_die_with_the_trainer() -> None:
    done = subprocess.run([sys.executable, "-c", ORPHANS], capture_output=True, timeout=60)
    workers = [int(pid) for pid in done.stdout.split()]
    assert len(workers) == 2
    deadline = time.monotonic() + 10.0
    while not all(map(_has_ended, workers)):
        assert time.monotonic() < deadline
        time.sleep(0.02)


def test_workers_that_cannot_live_end_the_training_in_one_line(
    tmp_path: Path, make_config: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "sitecustomize.py").write_text("import os\nos._exit(3)\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    with pytest.raises(WorkerError, match=r"4 workers in a row were lost.*exit status 3") as caught:
        train(make_config("ppo", 32, num_envs=2), tmp_path / "run")
    assert "\n" not in str(caught.value)
    assert read_status(tmp_path / "run").state == "failed"


def _train(
    config: Any, directory: Path, on_progress: Callable[[Progress], None] | None = None
) -> TrainingResult:
    return train(config, directory / "run", on_progress=on_progress)


def _kill_the_next(supervisor: Supervisor, pid: int) -> None:
    while supervisor.pids[0] == pid:
        time.sleep(0.001)
    os.kill(supervisor.pids[0], signal.SIGKILL)


def _has_ended(pid: int) -> bool:
    """Whether it is dead and nobody has asked about it, or gone."""
    try:
        return psutil.Process(pid).status() == psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return True


def _is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True
