"""The trainer's sign of life."""

import contextlib
import os
import socket
import threading
import time
from dataclasses import replace
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from singulate.runs.status import FINAL_STATES, RunStatus, write_status


class Heartbeat:
    """Writes a run's status now and then from a thread of its own; a context manager.

    It keeps beating during long updates of the network. Leaving the block without having set a
    final state writes one: ``failed`` with the text of an exception, otherwise ``stopped``.

    Args:
        run_dir: The run's directory, locked by this process.
        status: What is known at the start; process and host are filled in.
        interval_s: Time between two beats [s].
    """

    def __init__(self, run_dir: Path, status: RunStatus, interval_s: float = 1.0) -> None:
        self._run_dir = run_dir
        self._interval_s = interval_s
        self._status = replace(status, pid=os.getpid(), host=socket.gethostname())
        self._guard = threading.Lock()
        self._is_stopping = threading.Event()
        self._thread = threading.Thread(target=self._beat_on, name="heartbeat", daemon=True)

    @property
    def status(self) -> RunStatus:
        """What was last set."""
        return self._status

    def update(self, **changes: Any) -> None:
        """Change fields of the status; a new state is written at once, the rest with the next beat.

        Args:
            **changes: Fields of `RunStatus`.
        """
        with self._guard:
            is_urgent = changes.get("state", self._status.state) != self._status.state
            self._status = replace(self._status, **changes)
            if is_urgent:
                self._beat()

    def start(self) -> None:
        """Write the status and go on doing so.

        Raises:
            OSError: If the first one cannot be written.
        """
        self._status = replace(self._status, updated_at=time.time())
        write_status(self._run_dir, self._status)
        self._thread.start()

    def stop(self) -> None:
        """Write the status a last time."""
        self._is_stopping.set()
        if self._thread.is_alive():
            self._thread.join()
        with self._guard:
            self._beat()

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._status.state not in FINAL_STATES:
            if exc is None or isinstance(exc, KeyboardInterrupt):
                self.update(state="stopped", eta_s=None)
            else:
                text = " ".join(str(exc).split()) or "no further word"
                self.update(state="failed", error=f"{type(exc).__name__}: {text}", eta_s=None)
        self.stop()

    def _beat_on(self) -> None:
        while not self._is_stopping.wait(self._interval_s):
            with self._guard:
                self._beat()

    def _beat(self) -> None:
        self._status = replace(self._status, updated_at=time.time())
        # A full disk must not end the training; the age of the status shows that it is stale.
        with contextlib.suppress(OSError):
            write_status(self._run_dir, self._status)
