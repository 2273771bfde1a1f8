"""One child process from its start to its end, and the pipe to it."""

import multiprocessing
import os
import pickle
import queue
import signal
import socket
import threading
from collections.abc import Callable

from app.processes.child import ChildFailed, run_child
from app.processes.pipes import has_room

_INBOX_SIZE = 512


class ChildHandle:
    """A spawned child; a reader thread takes its messages off the pipe into a bounded inbox.

    When the inbox is full the thread waits, the pipe fills, and the child waits too.

    Args:
        target: ``module:function`` that the child runs.
        arguments: Its arguments after the pipe.
        niceness: Added to the child's niceness.
        on_message: Called from the reader thread after each message.
        name: What the process is called.
    """

    def __init__(
        self,
        target: str,
        arguments: tuple[object, ...],
        niceness: int,
        on_message: Callable[[], None],
        name: str,
    ) -> None:
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self._inbox: queue.Queue[object] = queue.Queue(_INBOX_SIZE)
        self._failure = ""
        self._on_message = on_message
        self._is_closing = False
        self.process = context.Process(
            target=run_child,
            args=(theirs, os.getpid(), target, niceness, arguments),
            name=name,
            daemon=True,
        )
        self.process.start()
        theirs.close()
        self._reader = threading.Thread(target=self._read, name=f"{name} reader", daemon=True)
        self._reader.start()

    def send(self, message: object) -> bool:
        """Write a small message; False where the child is gone or has stopped reading."""
        if not has_room(self.connection):
            return False
        try:
            self.connection.send(message)
        except OSError:
            return False
        return True

    def receive(self) -> list[object]:
        """Messages that arrived since the last call, oldest first."""
        messages: list[object] = []
        while len(messages) < _INBOX_SIZE:
            try:
                messages.append(self._inbox.get_nowait())
            except queue.Empty:
                break
        return messages

    def describe_end(self) -> str:
        """Why the child ended, as the end of a sentence."""
        self._reader.join(1.0)
        code = self.process.exitcode
        if self._failure:
            return f"stopped with an error ({self._failure})"
        if code is not None and code < 0:
            return f"was killed (signal {-code}, {signal.Signals(-code).name})"
        return f"ended unexpectedly (exit status {code})"

    def close(self, timeout_s: float) -> None:
        """Hang up, wait, then terminate, then kill."""
        self._is_closing = True
        if self.process.is_alive():
            self._hang_up()
            self.process.join(timeout_s)
        for end in (self.process.terminate, self.process.kill):
            if self.process.is_alive():
                end()
                self.process.join(1.0)
        self._hang_up()
        self._reader.join(1.0)
        self.connection.close()

    def _hang_up(self) -> None:
        # A reader thread may be inside recv: shut the socket down, so that both ends see its end.
        try:
            with socket.socket(fileno=os.dup(self.connection.fileno())) as end:
                end.shutdown(socket.SHUT_RDWR)
        except OSError:
            return

    def _read(self) -> None:
        while not self._is_closing:
            try:
                message = self.connection.recv()
            except (EOFError, OSError, pickle.UnpicklingError):
                return
            if isinstance(message, ChildFailed):
                self._failure = message.reason
                continue
            self._put(message)
            self._on_message()

    def _put(self, message: object) -> None:
        while not self._is_closing:
            try:
                return self._inbox.put(message, timeout=0.2)
            except queue.Full:
                continue
