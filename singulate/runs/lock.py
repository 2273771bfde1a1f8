"""One trainer a run: a lock that the kernel lets go of when its process dies, however it dies."""

import contextlib
import fcntl
import os
import time
from pathlib import Path
from types import TracebackType
from typing import Self

from singulate.exceptions import RunError
from singulate.runs.run_directory import RunDirectory

PATIENCE_S = 0.5
"""How long to try: somebody who only looks holds the lock for microseconds."""


class RunLock:
    """Sole right to write a run; a context manager.

    Args:
        run_dir: The run's directory, which exists.
    """

    def __init__(self, run_dir: Path) -> None:
        self._run_dir = run_dir
        self._path = RunDirectory(run_dir).lock_path
        self._descriptor: int | None = None

    @property
    def is_held(self) -> bool:
        """Whether this object holds the lock."""
        return self._descriptor is not None

    def acquire(self) -> None:
        """Take the lock.

        Raises:
            RunError: If another process has it, or the directory is missing or not writable.
        """
        try:
            descriptor = os.open(self._path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        except OSError as error:
            raise RunError(
                f"{self._run_dir}: cannot be written ({error.strerror or error})"
            ) from error
        deadline = time.monotonic() + PATIENCE_S
        while not _try_lock(descriptor, fcntl.LOCK_EX):
            if time.monotonic() > deadline:
                pid = _read_pid(descriptor)
                os.close(descriptor)
                raise RunError(f"{self._run_dir}: in use by process {pid or 'unknown'}")
            time.sleep(0.02)
        with contextlib.suppress(OSError):  # the text is for people; a full disk must not matter
            os.ftruncate(descriptor, 0)
            os.pwrite(descriptor, str(os.getpid()).encode(), 0)
        self._descriptor = descriptor

    def release(self) -> None:
        """Give the lock back; harmless when it is not held."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    def __enter__(self) -> Self:
        self.acquire()
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.release()


def lock_holder(run_dir: Path) -> int | None:
    """Who is writing a run.

    Returns:
        Process id of the trainer, 0 where it is unknown, None where nobody holds the lock.
    """
    try:
        descriptor = os.open(RunDirectory(run_dir).lock_path, os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return None
    try:
        return None if _try_lock(descriptor, fcntl.LOCK_SH) else _read_pid(descriptor)
    finally:
        os.close(descriptor)


def _try_lock(descriptor: int, kind: int) -> bool:
    try:
        fcntl.flock(descriptor, kind | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _read_pid(descriptor: int) -> int:
    try:
        return int(os.pread(descriptor, 20, 0) or b"0")
    except ValueError:
        return 0
