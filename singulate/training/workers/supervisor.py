"""Keeps the environments of a training going, whatever becomes of their processes."""

from collections.abc import Sequence
from dataclasses import dataclass
from multiprocessing.connection import wait

from singulate.exceptions import SingulateError
from singulate.training.episode_state import EpisodeState
from singulate.training.workers.env_worker import EnvWorker
from singulate.training.workers.messages import (
    Act,
    Acted,
    Answer,
    Failed,
    Request,
    Restore,
    Restored,
    Settings,
)
from singulate.training.workers.watchdog import Watchdog

MAX_FAILURES = 3
"""Workers in a row that may be lost before anything that was asked is answered."""


class WorkerError(SingulateError):
    """A worker's environment failed, or workers cannot be kept alive."""


@dataclass(frozen=True)
class WorkerLoss:
    """A worker that was replaced, and the episode that was truncated for it.

    Attributes:
        pid: Its process.
        reason: What became of it, one line.
        env_index: Environment whose push was lost; None if no push was, or with a worker before.
        episode_index: That environment's episode, which ends there.
    """

    pid: int
    reason: str
    env_index: int | None
    episode_index: int | None


class Supervisor:
    """Hands requests to the environments' workers and replaces a worker that is lost.

    Environment i lives in worker i modulo the number of workers. Pushes are pure, so a new worker
    replays the episodes of the lost one and they go on; only the push that was next in it is not
    tried again, because it may be what killed or blocked it.

    Args:
        settings: The environments.
        states: Where each begins.
        num_workers: Processes, at most one for each environment.

    Attributes:
        states: Where each environment is.
        losses: Workers lost so far that nobody has asked for.
    """

    def __init__(
        self, settings: Settings, states: Sequence[EpisodeState], num_workers: int
    ) -> None:
        self.states = list(states)
        self.losses: list[WorkerLoss] = []
        self._settings = settings
        self._pending: dict[int, Request] = {}
        self._num_failures = 0
        self._workers = [EnvWorker(settings) for _ in range(num_workers)]
        self._watchdog = Watchdog(self._workers)
        self._watchdog.start()

    @property
    def pids(self) -> list[int]:
        """Process ids of the workers; a replaced one has another."""
        return [worker.pid for worker in self._workers]

    def request(self, requests: Sequence[Request]) -> None:
        """Ask something of environments that are not busy; returns at once."""
        for request in requests:
            self._pending[request.env_index] = request
            self._workers[request.env_index % len(self._workers)].ask(request)

    def gather(self) -> list[Acted | Restored]:
        """Wait until all that was asked is answered; in the order of the environments.

        Raises:
            WorkerError: If an environment raised, or workers cannot be kept alive.
        """
        answers: dict[int, Acted | Restored] = {}
        self._watchdog.is_waiting = True
        while self._pending:
            busy = {w.connection: i for i, w in enumerate(self._workers) if w.num_unanswered}
            for connection in wait(list(busy)):
                self._read(busy[connection], answers)  # type: ignore[index]
        self._watchdog.is_waiting = False
        return [answers[index] for index in sorted(answers)]

    def close(self) -> None:
        """End the workers; may be called twice."""
        self._watchdog.close()
        for worker in self._workers:
            worker.kill("was no longer needed")
            worker.end()

    def _read(self, worker_index: int, answers: dict[int, Acted | Restored]) -> None:
        try:
            answer = self._workers[worker_index].receive()
        except (EOFError, OSError):
            self._replace(worker_index)
        else:
            self._take(answer, answers)

    def _take(self, answer: Answer, answers: dict[int, Acted | Restored]) -> None:
        if isinstance(answer, Failed):
            raise WorkerError(f"environment in a worker process: {answer.text}")
        index = answer.env_index
        request = self._pending.get(index)
        if isinstance(answer, Acted) and isinstance(request, Act):
            state = self.states[index].after_push(request.action)
            self.states[index] = state.after_reset() if answer.is_done else state
        elif isinstance(answer, Restored) and isinstance(request, Restore):
            self.states[index] = request.state
        else:
            return  # a new worker is where the lost one was
        self._num_failures = 0
        del self._pending[index]
        answers[index] = answer

    def _replace(self, worker_index: int) -> None:
        """Start another worker, bring it to where the lost one was, and go on."""
        lost = self._workers[worker_index]
        reason = f"worker process {lost.pid} {lost.end()}"
        self._num_failures += 1
        if self._num_failures > MAX_FAILURES:
            raise WorkerError(f"{self._num_failures} workers in a row were lost: {reason}")
        worker = self._workers[worker_index] = EnvWorker(self._settings)
        env_indices = range(worker_index, len(self.states), len(self._workers))
        for index in env_indices:
            if not isinstance(self._pending.get(index), Restore):
                worker.ask(Restore(index, self.states[index]))
        unanswered = [self._pending[index] for index in env_indices if index in self._pending]
        first = unanswered[0] if unanswered else None
        if isinstance(first, Act) and not first.loss:
            unanswered[0] = first._replace(loss=reason)
            episode_index = self.states[first.env_index].episode_index
            self.losses.append(WorkerLoss(lost.pid, reason, first.env_index, episode_index))
        else:
            self.losses.append(WorkerLoss(lost.pid, reason, None, None))
        self.request(unanswered)
