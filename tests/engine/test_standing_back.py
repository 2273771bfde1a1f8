"""A process that stands back does so behind other sessions, too."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from singulate.engine.standing_back import set_back

WAIT = """
import sys, time
from singulate.engine.standing_back import stand_back
stand_back(int(sys.argv[1]))
print("ready", flush=True)
time.sleep(60)
"""


def start(niceness: int, *, leads_session: bool) -> "subprocess.Popen[str]":
    process = subprocess.Popen(
        [sys.executable, "-c", WAIT, str(niceness)],
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=leads_session,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    return process


@pytest.fixture(params=[False, True], ids=["of our session", "of its own"])
def process(request: pytest.FixtureRequest) -> Iterator["subprocess.Popen[str]"]:
    started = start(4, leads_session=request.param)
    with started:
        yield started
        started.kill()


def session_niceness(pid: int) -> int:
    """As "/autogroup-25 nice 4" tells it; the file is empty where a process is in no autogroup."""
    session = Path(f"/proc/{pid}/autogroup")
    told = session.read_text() if session.exists() else ""
    if not told:
        pytest.skip("no autogroups here")
    return int(told.split()[-1])


def test_it_is_as_nice_as_asked_for(process: "subprocess.Popen[str]") -> None:
    assert os.getpriority(os.PRIO_PROCESS, process.pid) == min(os.nice(0) + 4, 19)
    assert os.getsid(process.pid) == process.pid


def test_its_session_is_as_nice_and_ours_is_not(process: "subprocess.Popen[str]") -> None:
    assert session_niceness(process.pid) == min(os.nice(0) + 4, 19)
    assert session_niceness(os.getpid()) < session_niceness(process.pid)


def test_one_that_does_not_stand_back_stays_in_our_session() -> None:
    with start(0, leads_session=False) as process:
        assert os.getsid(process.pid) == os.getsid(0)
        assert os.getpriority(os.PRIO_PROCESS, process.pid) == os.nice(0)
        process.kill()


def test_a_session_is_left_alone_by_one_that_does_not_lead_it() -> None:
    with start(0, leads_session=False) as process:
        try:
            before = session_niceness(process.pid)
            set_back(process.pid, os.nice(0) + 3)
            assert os.getpriority(os.PRIO_PROCESS, process.pid) == min(os.nice(0) + 3, 19)
            assert session_niceness(process.pid) == before
        finally:
            process.kill()


def test_a_process_that_is_gone_is_refused() -> None:
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        pass
    with pytest.raises(ProcessLookupError):
        set_back(process.pid, 5)


@pytest.mark.skipif(sys.platform != "linux", reason="others do not bind processes to cores")
def test_it_leaves_a_core_to_another_session() -> None:
    """Two loops on one core, in sessions of their own: the nicer one gets the smaller part."""
    core = min(os.sched_getaffinity(0))
    loop = (
        "import os, sys, time\n"
        "from singulate.engine.standing_back import stand_back\n"
        f"os.sched_setaffinity(0, {{{core}}})\n"
        "stand_back(int(sys.argv[1]))\n"
        "print('ready', flush=True)\n"
        "while True: pass\n"
    )
    loops = [
        subprocess.Popen(
            [sys.executable, "-c", loop, str(niceness)],
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        for niceness in (0, 15)
    ]
    for each in loops:
        assert each.stdout is not None
        assert each.stdout.readline() == "ready\n"
    before = [cpu_seconds(each.pid) for each in loops]
    time.sleep(2.0)
    prompt, nice = (
        cpu_seconds(each.pid) - start for each, start in zip(loops, before, strict=True)
    )
    for each in loops:
        each.send_signal(signal.SIGKILL)
        each.communicate()
    assert prompt > 4 * nice


def cpu_seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
