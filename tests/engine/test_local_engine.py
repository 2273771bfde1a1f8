import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import engine_tasks as tasks
import psutil
import pytest

from singulate.engine import EngineError, LocalEngine
from singulate.exceptions import InvalidValueError

PARENT = """
import time, engine_tasks
from singulate.engine import LocalEngine
engine = LocalEngine(num_workers=2)
list(engine.submit(engine_tasks.square, [1, 2, 3], object))
engine.submit(engine_tasks.sleep, [60.0, 60.0], object)
print(*engine.pids, flush=True)
time.sleep(60)
"""


def wait_until(condition: Callable[[], bool], timeout_s: float = 10.0) -> bool:
    give_up = time.monotonic() + timeout_s
    while not condition() and time.monotonic() < give_up:
        time.sleep(0.02)
    return condition()


def is_running(pid: int) -> bool:
    return psutil.pid_exists(pid) and psutil.Process(pid).status() != psutil.STATUS_ZOMBIE


@pytest.mark.parametrize("death", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_workers_die_with_their_parent(death: signal.Signals) -> None:
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    command = [sys.executable, "-c", PARENT]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, env=environment, text=True) as parent:
        assert parent.stdout is not None
        pids = [int(pid) for pid in parent.stdout.readline().split()]
        assert len(pids) == 2
        assert all(is_running(pid) for pid in pids)
        parent.send_signal(death)
        parent.wait(timeout=10)
    assert wait_until(lambda: not any(is_running(pid) for pid in pids))


def test_workers_end_when_the_engine_closes() -> None:
    with LocalEngine(num_workers=2) as engine:
        list(engine.submit(tasks.square, [1, 2], object))
        pids = engine.pids
        assert len(pids) == 2
    assert not any(is_running(pid) for pid in pids)


def test_a_killed_idle_worker_is_replaced() -> None:
    with LocalEngine(num_workers=1) as engine:
        list(engine.submit(tasks.square, [1], object))
        (pid,) = engine.pids
        os.kill(pid, signal.SIGKILL)
        assert wait_until(lambda: engine.pids not in ([], [pid]))
        assert [r.value for r in engine.submit(tasks.square, [4], object)] == [16]


def test_a_hung_worker_is_replaced() -> None:
    with LocalEngine(num_workers=1, hang_timeout_s=0.3) as engine:
        (result,) = engine.submit(tasks.sleep, [60.0], object)
        assert result.error is not None
        assert "SIGKILL" in result.error


def test_no_task_of_a_batch_runs_that_was_cancelled_while_its_worker_started() -> None:
    with LocalEngine(num_workers=1, cancel_grace_s=60.0) as engine:
        batch = engine.submit(tasks.sleep, [60.0, 60.0], object)
        time.sleep(0.03)  # the tasks are on their way to a worker that is not there yet
        batch.cancel()
        began = time.monotonic()
        assert [r.value for r in engine.submit(tasks.square, [4], object)] == [16]
        assert time.monotonic() - began < 30.0


def test_a_worker_that_ignores_a_cancel_is_replaced() -> None:
    with LocalEngine(num_workers=1, cancel_grace_s=0.2) as engine:
        list(engine.submit(tasks.square, [1], object))
        (pid,) = engine.pids
        engine.submit(tasks.sleep, [60.0], object).cancel()
        assert [r.value for r in engine.submit(tasks.square, [4], object)] == [16]
        time.sleep(0.1)
        stuck = engine.submit(tasks.sleep, [60.0], object)
        time.sleep(0.3)
        stuck.cancel()
        began = time.monotonic()
        assert [r.value for r in engine.submit(tasks.square, [5], object)] == [25]
        assert time.monotonic() - began < 5.0
        assert engine.pids != [pid]


def test_workers_are_nice() -> None:
    with LocalEngine(num_workers=1, niceness=3) as engine:
        (result,) = engine.submit(tasks.niceness, [0], object)
        assert result.value == min(os.nice(0) + 3, 19)


def test_workers_that_cannot_start_are_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    with LocalEngine(num_workers=2) as engine:
        assert not engine.has_failed
        with pytest.raises(EngineError, match="before they are ready"):
            list(engine.submit(tasks.square, [1], object))
        assert engine.has_failed


@pytest.mark.parametrize(("key", "value"), [("num_workers", 0), ("niceness", 20)])
def test_values_out_of_range_are_refused(key: str, value: int) -> None:
    arguments = {"num_workers": 1} | {key: value}
    with pytest.raises(InvalidValueError, match=key):
        LocalEngine(**arguments)
