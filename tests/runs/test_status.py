import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import asdict
from pathlib import Path

import pytest

from singulate.exceptions import RunError
from singulate.runs import Heartbeat, RunLock, RunStatus, log_tail, read_status
from singulate.runs.status import write_status

TRAINER = """
import sys, time
from pathlib import Path
from singulate.runs import Heartbeat, RunLock, RunStatus
run_dir = Path(sys.argv[1])
with RunLock(run_dir), Heartbeat(run_dir, RunStatus(state="running", total_steps=9), 0.05):
    print("beating", flush=True)
    time.sleep(60)
"""


def test_a_living_trainer(run_dir: Path) -> None:
    with RunLock(run_dir), Heartbeat(run_dir, RunStatus(total_steps=100), 0.02) as heartbeat:
        assert read_status(run_dir).state == "starting"
        heartbeat.update(state="running", num_steps=10, pushes_per_second=5.0, eta_s=18.0)
        status = read_status(run_dir)
        assert (status.state, status.num_steps, status.eta_s) == ("running", 10, 18.0)
        assert status.is_alive
        assert status.pid == os.getpid()
        time.sleep(0.1)
        assert read_status(run_dir).updated_at > status.updated_at
        heartbeat.update(state="finished")
    status = read_status(run_dir)
    assert status.state == "finished"
    assert not status.is_alive


def test_leaving_without_a_word_means_stopped(run_dir: Path) -> None:
    with Heartbeat(run_dir, RunStatus(state="running")):
        pass
    assert read_status(run_dir).state == "stopped"


def test_an_exception_is_the_reason(run_dir: Path) -> None:
    with pytest.raises(ValueError), Heartbeat(run_dir, RunStatus(state="running")):
        raise ValueError("loss is\nnot finite")
    status = read_status(run_dir)
    assert (status.state, status.error) == ("failed", "ValueError: loss is not finite")


def test_a_killed_trainer_is_found_dead_with_a_reason(run_dir: Path) -> None:
    log = run_dir / "trainer.log"
    log.write_text("Traceback\nMemoryError: no more\n\n")
    trainer = subprocess.Popen(
        [sys.executable, "-c", TRAINER, str(run_dir)], stdout=subprocess.PIPE, text=True
    )
    assert trainer.stdout is not None
    assert trainer.stdout.readline() == "beating\n"
    status = read_status(run_dir)
    assert (status.state, status.is_alive) == ("running", True)
    trainer.send_signal(signal.SIGKILL)
    trainer.communicate()
    status = read_status(run_dir)
    assert (status.state, status.is_alive) == ("died", False)
    assert f"process {trainer.pid} ended without a word" in status.error
    assert status.error.endswith("its last output: MemoryError: no more")


def test_a_run_that_never_began(run_dir: Path) -> None:
    now = time.time()
    assert read_status(run_dir, now).is_alive
    later = read_status(run_dir, now + 100.0)
    assert (later.state, later.is_alive) == ("died", False)
    assert later.error.startswith("the trainer ended without a word")


def test_a_trainer_on_another_machine_is_judged_by_its_heartbeat(run_dir: Path) -> None:
    write_status(run_dir, RunStatus(state="running", pid=1, host="elsewhere", updated_at=1000.0))
    assert read_status(run_dir, 1010.0).is_alive
    assert read_status(run_dir, 1010.0).age_s(1010.0) == 10.0
    assert read_status(run_dir, 1100.0).state == "died"


@pytest.mark.parametrize(
    "change",
    [
        {"state": "dancing"},
        {"state": "died"},
        {"pid": "1"},
        {"num_steps": 1.5},
        {"eta_s": 10**400},
        {"pushes_per_second": True},
        {"updated_at": None},
        {"unknown": 1},
    ],
)
def test_a_damaged_status(run_dir: Path, change: dict[str, object]) -> None:
    content = {**asdict(RunStatus(state="running")), **change}
    (run_dir / "status.json").write_text(json.dumps(content))
    with pytest.raises(RunError, match=r"status\.json"):
        read_status(run_dir)


def test_tail_of_a_long_log(run_dir: Path) -> None:
    assert log_tail(run_dir) == []
    (run_dir / "trainer.log").write_bytes(b"x\n" * 50_000 + b"last but one\n\xff last\n")
    assert log_tail(run_dir, 2) == ["last but one", "\N{REPLACEMENT CHARACTER} last"]
