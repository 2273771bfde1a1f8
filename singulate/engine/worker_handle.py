"""The engine's end of one local worker process."""

import sys
import time
from collections import deque
from contextlib import suppress

from singulate.engine.child_process import ChildProcess
from singulate.engine.messages import DropBatch, RunTask

MAX_PREFETCH_BYTES = 2**14
"""A task larger than this is sent only to an idle worker: two full pipes would wait for ever."""

START_TIMEOUT_S = 60.0
"""A worker that is not ready by then is replaced [s]."""


class WorkerHandle:
    """Starts a worker and knows what it was given.

    Args:
        niceness: Added to the engine's own.
        hang_timeout_s: A task that takes longer counts as hung.

    Attributes:
        connection: Messages to and from the worker; at its end the worker is dead.
        assigned: Tasks in the order in which the worker runs them; the first one is running.
        is_ready: Whether it has ever answered.
        deadline: When the start or the running task counts as hung, by `time.monotonic` [s].
    """

    def __init__(self, niceness: int, hang_timeout_s: float) -> None:
        self._process = ChildProcess("singulate.engine.worker", [str(niceness)])
        self.connection = self._process.connection
        self._hang_timeout_s = hang_timeout_s
        self.assigned: deque[RunTask] = deque()
        self.is_ready = False
        self.deadline = time.monotonic() + START_TIMEOUT_S
        with suppress(BrokenPipeError, ConnectionResetError):
            self.connection.send(list(sys.path))

    @property
    def pid(self) -> int:
        """Process id."""
        return self._process.pid

    def note_ready(self) -> None:
        """The worker has answered; its first task, if any, begins now."""
        self.is_ready = True
        self._restart_clock()

    def take(self, task: RunTask) -> bool:
        """Send a task to run, or to wait behind the running one.

        Returns:
            Whether it was sent; a large one waits until the worker is idle.
        """
        if self.assigned and task.num_bytes > MAX_PREFETCH_BYTES:
            return False
        self.send(task)
        self.assigned.append(task)
        if self.is_ready and len(self.assigned) == 1:
            self._restart_clock()
        return True

    def note_finished(self) -> None:
        """The running task has ended and the next one, if any, has begun."""
        self.assigned.popleft()
        self._restart_clock()

    def hurry(self, grace_s: float) -> None:
        """Bring the deadline of a running task forward."""
        if self.is_ready:
            self.deadline = min(self.deadline, time.monotonic() + grace_s)

    def send(self, message: RunTask | DropBatch) -> None:
        """Send it; a dead worker is noticed where its messages are read."""
        with suppress(BrokenPipeError, ConnectionResetError):
            self.connection.send(message)

    def kill(self) -> None:
        """End the process at once."""
        self._process.kill()

    def end(self, grace_s: float = 0.0) -> str:
        """Close the pipe, wait for the process, kill it after the grace.

        Returns:
            How it ended, for people.
        """
        return self._process.end(grace_s)

    def _restart_clock(self) -> None:
        timeout = self._hang_timeout_s if self.assigned else float("inf")
        self.deadline = time.monotonic() + timeout
