import signal
import subprocess
import sys
from pathlib import Path

import pytest

from singulate.exceptions import RunError
from singulate.runs import RunLock, lock_holder

HOLDER = """
import sys, time
from pathlib import Path
from singulate.runs import RunLock
RunLock(Path(sys.argv[1])).acquire()
print("locked", flush=True)
time.sleep(60)
"""


def test_the_second_process_is_told_who_is_first(run_dir: Path) -> None:
    assert lock_holder(run_dir) is None
    first = subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(run_dir)], stdout=subprocess.PIPE, text=True
    )
    try:
        assert first.stdout is not None
        assert first.stdout.readline() == "locked\n"
        assert lock_holder(run_dir) == first.pid
        with pytest.raises(RunError, match=f"in use by process {first.pid}"):
            RunLock(run_dir).acquire()
    finally:
        first.send_signal(signal.SIGKILL)
        first.communicate()
    assert lock_holder(run_dir) is None
    with RunLock(run_dir) as lock:
        assert lock.is_held
    assert lock_holder(run_dir) is None


def test_it_holds_within_a_process_too(run_dir: Path) -> None:
    with RunLock(run_dir), pytest.raises(RunError, match="in use by process"):
        RunLock(run_dir).acquire()


def test_no_directory(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="cannot be written"):
        RunLock(tmp_path / "nowhere").acquire()
    assert lock_holder(tmp_path / "nowhere") is None
