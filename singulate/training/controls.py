"""What people want from a trainer right now."""

import contextlib
import signal
import threading
from collections.abc import Iterator
from pathlib import Path
from types import FrameType, TracebackType
from typing import Self

from singulate.runs import ControlInbox, Heartbeat

POLL_INTERVAL_S = 0.05


class Controls:
    """Listens to a run's control channel and to signals; a context manager.

    Attributes:
        was_interrupted: Whether Ctrl-C was pressed.

    A thread of its own reads the messages, so that the status says ``pausing`` or ``stopping`` at
    once, even in the middle of an update; the trainer acts at its next safe point.

    Args:
        run_dir: The run's directory, locked by this process.
        heartbeat: Where the state is shown.
    """

    def __init__(self, run_dir: Path, heartbeat: Heartbeat) -> None:
        self._inbox = ControlInbox(run_dir)
        self._heartbeat = heartbeat
        self._changed = threading.Condition()
        self._is_closing = threading.Event()
        self._is_pausing = False
        self._is_stopping = False
        self._wants_checkpoint = False
        self.was_interrupted = False
        self._thread = threading.Thread(target=self._listen, name="controls", daemon=True)

    @property
    def is_stopping(self) -> bool:
        """Whether training shall end at the next safe point."""
        return self._is_stopping

    @property
    def is_pausing(self) -> bool:
        """Whether training shall wait."""
        return self._is_pausing and not self._is_stopping

    def take_checkpoint_request(self) -> bool:
        """Whether a checkpoint was asked for since the last call."""
        with self._changed:
            wanted, self._wants_checkpoint = self._wants_checkpoint, False
            return wanted

    def request(self, command: str) -> None:
        """Ask for one of ``pause``, ``resume``, ``stop``, ``checkpoint``."""
        with self._changed:
            if command == "checkpoint":
                self._wants_checkpoint = True
            elif command == "stop":
                self._heartbeat.update(state="stopping")
                self._is_stopping = True
            elif not self._is_stopping:
                is_pausing = command == "pause"
                self._heartbeat.update(state="pausing" if is_pausing else "running")
                self._is_pausing = is_pausing
            self._changed.notify_all()

    def wait_while_paused(self) -> None:
        """Return when training shall go on or stop, or when a checkpoint is asked for."""
        with self._changed:
            while self.is_pausing and not self._wants_checkpoint:
                self._rest()

    def wait_for_resume(self) -> None:
        """Return when training shall go on or stop; for where no checkpoint can be saved."""
        with self._changed:
            while self.is_pausing:
                self._rest()

    def _rest(self) -> None:
        if self._heartbeat.status.state != "paused":
            self._heartbeat.update(state="paused", pushes_per_second=0.0, eta_s=None)
        self._changed.wait(timeout=1.0)

    def __enter__(self) -> Self:
        self._inbox.clear()
        self._thread.start()
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._is_closing.set()
        self._thread.join()

    def _listen(self) -> None:
        while not self._is_closing.wait(POLL_INTERVAL_S):
            for message in self._inbox.drain():
                self.request(message.command)


@contextlib.contextmanager
def stop_on_signals(controls: Controls) -> Iterator[None]:
    """Let SIGTERM, and the first Ctrl-C, stop the training after a checkpoint.

    Signals reach a process's main thread only; elsewhere this does nothing.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        controls.was_interrupted |= number == signal.SIGINT
        signal.signal(signal.SIGINT, signal.default_int_handler)
        # The handler may interrupt a holder of the lock; another thread can wait for it.
        threading.Thread(target=controls.request, args=("stop",), daemon=True).start()

    before = {n: signal.signal(n, stop) for n in (signal.SIGTERM, signal.SIGINT)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
