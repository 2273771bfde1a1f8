import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from app.processes.supervised import SupervisedProcess


@pytest.fixture(autouse=True)
def children_importable(monkeypatch):
    monkeypatch.syspath_prepend(str(Path(__file__).parent))


@pytest.fixture
def supervise():
    made = []

    def start(function, **options):
        made.append(SupervisedProcess("The test process", f"children:{function}", **options))
        return made[-1]

    yield start
    for process in made:
        process.close()


def wait_for(condition, timeout_s=15.0):
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError("waited in vain")


def test_messages_go_both_ways_in_order(supervise):
    process = supervise("echo", arguments=lambda: ("p",))
    assert all(process.send(i) for i in range(3))
    received = []
    wait_for(lambda: received.extend(process.receive()) or len(received) == 3)
    assert received == [("p", 0), ("p", 1), ("p", 2)]


def test_a_killed_child_is_explained_and_restarted(supervise):
    starts = []
    process = supervise("echo", arguments=lambda: (starts.append(1) or f"life {len(starts)}",))
    first = process.pid
    os.kill(first, signal.SIGKILL)
    text = wait_for(process.watch)
    assert text == "The test process was killed (signal 9, SIGKILL) and was restarted."
    assert process.pid != first and process.watch() is None
    process.send("again")
    assert wait_for(process.receive) == [("life 2", "again")]


def test_an_exception_is_told_in_the_explanation(supervise):
    process = supervise("fail")
    process.send("go")
    text = wait_for(process.watch)
    assert "RuntimeError: the third wheel came off" in text


def test_a_child_that_keeps_dying_is_given_a_rest(supervise):
    process = supervise("fail")
    texts = []
    for _ in range(4):
        wait_for(lambda: process.send("go"))
        texts.append(wait_for(process.watch))
    assert "keeps ending" in texts[-1] and "Next try in 10 s" in texts[-1]
    assert not process.is_running and process.send("go") is False


def test_a_child_that_no_longer_answers_is_replaced(supervise):
    process = supervise("sleep_without_reading", answer_timeout_s=0.3)
    first = process.pid
    wait_for(process.receive)
    assert process.watch() is None
    time.sleep(0.4)
    assert process.watch() is None
    process.send("are you there?")
    assert wait_for(process.watch) == "The test process no longer answered and was restarted."
    assert process.pid != first and not psutil.pid_exists(first)
    process.send("and you?")
    time.sleep(0.4)
    process.send("a process that has never spoken may still be starting")
    assert process.watch() is None


def test_niceness_is_set(supervise):
    process = supervise("niceness", niceness=7)
    assert wait_for(process.receive) == [min(os.nice(0) + 7, 19)]


def test_a_flood_is_bounded(supervise):
    process = supervise("flood")
    received = wait_for(process.receive)
    time.sleep(1.0)  # many times as long as the inbox takes to fill
    more = process.receive()
    assert 0 < len(more) <= 512
    assert [number for number, _ in received + more] == list(range(len(received + more)))


def test_sending_to_a_child_that_does_not_read_never_waits(supervise, pace):
    process = supervise("sleep_without_reading")
    wait_for(process.receive)
    started = time.monotonic()
    results = [process.send(b"x" * 1000) for _ in range(1000)]
    assert time.monotonic() - started < 1.0 * pace
    assert results[0] is True and results[-1] is False


def test_close_ends_even_a_deaf_child(supervise):
    process = supervise("sleep_without_reading")
    wait_for(process.receive)
    child = psutil.Process(process.pid)
    process.close(timeout_s=0.2)
    assert not child.is_running()


def test_a_child_dies_with_a_killed_parent():
    program = (
        "import sys, time\n"
        f"sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
        "from app.processes.supervised import SupervisedProcess\n"
        "process = SupervisedProcess('x', 'children:sleep_without_reading')\n"
        "while not process.receive(): time.sleep(0.01)\n"
        "print(process.pid, flush=True)\n"
        "time.sleep(600)\n"
    )
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE) as parent:
        assert parent.stdout is not None
        child = int(parent.stdout.readline())
        assert psutil.pid_exists(child)
        parent.kill()
    wait_for(lambda: not psutil.pid_exists(child), timeout_s=5.0)
