"""A Python process of ours at the other end of a pipe."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from multiprocessing import Pipe

_THREADS = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "OPENCV_FOR_THREADS_NUM",
)
_ONE_THREAD = dict.fromkeys(_THREADS, "1")


class ChildProcess:
    """Starts ``python -m MODULE FD PARENT_PID ARGUMENTS``; numerical libraries use one thread.

    Args:
        module: What to run; it calls `die_with_parent` first.
        arguments: Further arguments.

    Attributes:
        connection: Our end of the pipe, whose other end is `FD`; at its end the child is dead.
    """

    def __init__(self, module: str, arguments: Sequence[str] = ()) -> None:
        self.connection, child = Pipe()
        with child:
            ends = [str(child.fileno()), str(os.getpid())]
            self._process = subprocess.Popen(
                [sys.executable, "-m", module, *ends, *arguments],
                pass_fds=[child.fileno()],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                env=os.environ
                | _ONE_THREAD
                | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
            )

    @property
    def pid(self) -> int:
        """Process id."""
        return self._process.pid

    def kill(self) -> None:
        """End the process at once, also one that was stopped."""
        self._process.kill()

    def end(self, grace_s: float = 0.0) -> str:
        """Close the pipe, wait for the process, kill it after the grace.

        Returns:
            How it ended, for people.
        """
        self.connection.close()
        give_up = time.monotonic() + grace_s
        while self._process.poll() is None and time.monotonic() < give_up:
            time.sleep(0.005)
        status = self._process.poll()
        if status is None:
            self._process.kill()
            status = self._process.wait()
        if status >= 0:
            return f"exit status {status}"
        return next((s.name for s in signal.Signals if s == -status), f"signal {-status}")
