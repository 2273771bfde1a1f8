"""The one thread that talks to the workers on a Ray cluster."""

import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from functools import partial
from queue import Empty, SimpleQueue
from typing import Any, NamedTuple

from ray.exceptions import RayError, RayTaskError

from singulate.engine.dispatcher import MAX_FAILED_STARTS
from singulate.engine.messages import DropBatch, Finished
from singulate.engine.queued_batch import QueuedBatch
from singulate.engine.ray_worker import RayWorkerHandle
from singulate.engine.task_queue import TaskQueue
from singulate.engine.tool_box import one_line

START_TIMEOUT_S = 60.0
"""Without any worker for this long while work waits, the engine gives up [s]."""

_TICK_S = 0.5


class Answer(NamedTuple):
    """An actor's answer: its return value, or how it failed."""

    worker: RayWorkerHandle
    future: Future[Any]


class RayDispatcher(threading.Thread):
    """Owns the actors and all bookkeeping; other threads only enqueue.

    An actor that waits for a free core of the cluster gets no task before it has answered, so that
    more actors than cores do no harm.

    Args:
        num_workers: Actors to keep.
        niceness: Added to their nodes' own.
        hang_timeout_s: A task that takes longer counts as a dead worker.
        cancel_grace_s: The same for a task that nobody waits for any more.
    """

    def __init__(
        self, num_workers: int, niceness: int, hang_timeout_s: float, cancel_grace_s: float
    ) -> None:
        super().__init__(name="ray engine", daemon=True)
        self._num_workers = num_workers
        self._cancel_grace_s = cancel_grace_s
        self._events: SimpleQueue[QueuedBatch[Any] | DropBatch | Answer | None] = SimpleQueue()
        self._make_worker: Callable[[], RayWorkerHandle] = partial(
            RayWorkerHandle, niceness, hang_timeout_s, self._note_answer
        )
        self._workers: list[RayWorkerHandle] = []
        self._queue = TaskQueue()
        self._num_failed_starts = 0
        self._last_alive = time.monotonic()
        self._failure = ""

    def request(self, request: QueuedBatch[Any] | DropBatch | None) -> None:
        """Enqueue a batch, a cancellation, or None for the end; from any thread."""
        self._events.put(request)

    def run(self) -> None:
        """Serve until the end is requested."""
        reason = "the engine has been closed"
        try:
            self._serve()
        except Exception as error:  # nobody may wait for results for ever
            reason = f"the engine has failed ({one_line(error)})"
        while not self._events.empty():
            event = self._events.get()
            if isinstance(event, QueuedBatch):
                event.abandon(reason)
        self._queue.abandon(reason)
        for worker in self._workers:
            worker.kill()

    def _note_answer(self, worker: RayWorkerHandle, future: Future[Any]) -> None:
        self._events.put(Answer(worker, future))

    def _serve(self) -> None:
        self._workers = [self._make_worker() for _ in range(self._num_workers)]
        while True:
            try:
                event = self._events.get(timeout=_TICK_S)
            except Empty:
                self._kill_hung()
                continue
            if event is None:
                return
            self._handle(event)
            self._hand_out()

    def _handle(self, event: QueuedBatch[Any] | DropBatch | Answer) -> None:
        if isinstance(event, DropBatch):
            self._queue.drop(event.batch_id)
            for worker in self._workers:
                if worker.task is not None and worker.task.key.batch_id == event.batch_id:
                    worker.hurry(self._cancel_grace_s)
        elif isinstance(event, Answer):
            if event.worker in self._workers:
                self._read(*event)
        elif self._failure:
            event.abandon(self._failure)
        else:
            self._queue.add(event)

    def _read(self, worker: RayWorkerHandle, future: Future[Any]) -> None:
        try:
            answer = future.result()
        except RayError as error:
            task = worker.task
            if task is None or not isinstance(error, RayTaskError):
                self._replace(worker, how_it_ended(error))
                return
            # The task is caught in the worker, so this is its outcome that cannot be sent.
            answer = Finished(task.key, None, one_line(error))
        if isinstance(answer, Finished):
            worker.note_finished()
            self._queue.finish(*answer)
        else:
            worker.is_ready = True
            self._num_failed_starts = 0

    def _hand_out(self) -> None:
        for worker in self._workers:
            if worker.is_ready and worker.task is None:
                task = self._queue.next_task()
                if task is None:
                    return
                worker.take(task)

    def _replace(self, worker: RayWorkerHandle, reason: str) -> None:
        """Start another worker; retry what the dead one was doing, once."""
        worker.kill()
        self._workers.remove(worker)
        if worker.task is not None:
            self._queue.note_death(worker.task, True, reason)
        self._num_failed_starts += not worker.is_ready
        if self._num_failed_starts < MAX_FAILED_STARTS:
            self._workers.append(self._make_worker())
        elif not self._workers:
            self._give_up(f"workers end before they are ready ({reason})")

    def _kill_hung(self) -> None:
        now = time.monotonic()
        for worker in self._workers:
            if worker.deadline < now:
                worker.deadline = float("inf")
                worker.kill()  # its answer becomes an error, and `_read` replaces it
        if any(worker.is_ready for worker in self._workers):
            self._last_alive = now
        elif now - self._last_alive > START_TIMEOUT_S and not self._failure:
            self._give_up(f"the cluster has started no worker within {START_TIMEOUT_S:.0f} s")

    def _give_up(self, reason: str) -> None:
        self._failure = reason
        self._queue.abandon(reason)


def how_it_ended(error: Exception) -> str:
    """The line of Ray's long explanations that says why a worker has ended."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    telling = [line for line in lines if "because" in line]
    return (telling or lines or [type(error).__name__])[0]
