"""The trainer's end of one worker process."""

from contextlib import suppress

from singulate.engine.child_process import ChildProcess
from singulate.training.workers.messages import Answer, Request, Settings


class EnvWorker:
    """Starts a worker and counts its signs of life.

    The worker dies with the thread that makes this.

    Args:
        settings: Its environments.

    Attributes:
        connection: Messages to and from the worker; at its end the worker is dead.
        num_unanswered: Requests that it has not answered yet.
        num_signs: Requests and answers so far: while it does not change, the worker is silent.
        has_answered: Whether it has ever answered.
    """

    def __init__(self, settings: Settings) -> None:
        self._process = ChildProcess("singulate.training.workers.worker")
        self._reason = ""
        self.connection = self._process.connection
        self.num_unanswered = 0
        self.num_signs = 0
        self.has_answered = False
        self._send(settings)

    @property
    def pid(self) -> int:
        """Process id."""
        return self._process.pid

    def ask(self, request: Request) -> None:
        """Send a request; a dead worker is noticed where its answers are read."""
        self.num_unanswered += 1
        self.num_signs += 1
        self._send(request)

    def receive(self) -> Answer:
        """Wait for the next answer.

        Raises:
            EOFError: If the worker is dead.
            OSError: Likewise.
        """
        answer: Answer = self.connection.recv()
        self.num_unanswered -= 1
        self.num_signs += 1
        self.has_answered = True
        return answer

    def kill(self, reason: str) -> None:
        """End the process at once, also one that was stopped; its connection then ends, too."""
        self._reason = reason
        self._process.kill()

    def end(self) -> str:
        """Make sure that the process is gone.

        Returns:
            What became of it, for people.
        """
        how = self._process.end(grace_s=0.05)
        return self._reason or f"ended ({how})"

    def _send(self, message: Request | Settings) -> None:
        with suppress(BrokenPipeError, ConnectionResetError):
            self.connection.send(message)
