"""A child process that is watched, restarted and explained."""

import time
from collections import deque
from collections.abc import Callable

from app.processes.child_handle import ChildHandle
from app.processes.patience import Patience

_FREE_RESTARTS = 3
_CALM_AFTER_S = 60.0
_HOLD_OFF_S = 10.0


class SupervisedProcess:
    """One spawned process behind a pipe; nothing here blocks.

    Start it from a thread that lives as long as the program (see `die_with_parent`). A reader
    thread takes messages off the pipe into a bounded inbox; when that is full the child waits.

    Args:
        name: What it is, for people: "The scene process".
        target: ``module:function`` that the child runs as ``function(connection, *arguments)``.
        arguments: Called at each start, so that a restarted child begins where the last one was.
        niceness: Added to the child's niceness.
        on_message: Called from the reader thread after each message; must return at once.
        answer_timeout_s: A child that has spoken before, and says nothing for this long after a
            message to it, is killed; None for one that need not answer.
    """

    def __init__(
        self,
        name: str,
        target: str,
        arguments: Callable[[], tuple[object, ...]] = tuple,
        niceness: int = 0,
        on_message: Callable[[], None] | None = None,
        answer_timeout_s: float | None = None,
    ) -> None:
        self.name = name
        self._target = target
        self._arguments = arguments
        self._niceness = niceness
        self._on_message = on_message or (lambda: None)
        self._patience = Patience(answer_timeout_s)
        self._deaths: deque[float] = deque(maxlen=_FREE_RESTARTS + 1)
        self._restart_at: float | None = None
        self._life = self._start()

    @property
    def pid(self) -> int:
        """Process id of the current child."""
        pid = self._life.process.pid
        assert pid is not None
        return pid

    @property
    def is_running(self) -> bool:
        """Whether a child is there to talk to."""
        return self._restart_at is None and self._life.process.is_alive()

    def send(self, message: object) -> bool:
        """Send a small message.

        Returns:
            False if it was not sent, because the child is dead or has stopped reading.
        """
        self._patience.note_question()
        return self._restart_at is None and self._life.send(message)

    def receive(self) -> list[object]:
        """Messages that arrived since the last call, oldest first."""
        messages = self._life.receive()
        if messages:
            self._patience.note_answer()
        return messages

    def watch(self) -> str | None:
        """Restart a dead child.

        Returns:
            One line about what happened, on the call that finds it; None otherwise.
        """
        now = time.monotonic()
        if self._restart_at is not None:
            if now >= self._restart_at:
                self._restart_at = None
                self._life = self._start()
            return None
        is_hung = self._patience.is_over
        if self._life.process.exitcode is None and not is_hung:
            return None
        reason = "no longer answered" if is_hung else self._life.describe_end()
        self._life.close(0.0)
        self._deaths.append(now)
        crowded = len(self._deaths) > _FREE_RESTARTS and now - self._deaths[0] < _CALM_AFTER_S
        if crowded:
            self._restart_at = now + _HOLD_OFF_S
            return f"{self.name} keeps ending: {reason}. Next try in {_HOLD_OFF_S:.0f} s."
        self._life = self._start()
        return f"{self.name} {reason} and was restarted."

    def close(self, timeout_s: float = 0.3) -> None:
        """End the child for good: close its pipe, then terminate, then kill it."""
        self._life.close(timeout_s)

    def _start(self) -> ChildHandle:
        self._patience.start_over()
        return ChildHandle(
            self._target, self._arguments(), self._niceness, self._on_message, self.name
        )
