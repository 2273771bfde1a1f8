"""The one thread that talks to the local workers."""

import threading
import time
from collections import deque
from multiprocessing import Pipe
from multiprocessing.connection import wait
from queue import SimpleQueue
from typing import Any

from singulate.engine.local_batch import LocalBatch
from singulate.engine.messages import DropBatch, Finished, Ready, RunTask
from singulate.engine.worker_handle import WorkerHandle

MAX_ATTEMPTS = 2
"""Workers that may die under a task before it is reported."""

MAX_FAILED_STARTS = 3
"""Workers in a row that may die before they are ready."""

_TICK_S = 0.5


class Dispatcher(threading.Thread):
    """Owns the workers and all bookkeeping; other threads only enqueue.

    Workers are started here and nowhere else, because Linux kills a process that asked to die with
    its parent as soon as the *thread* that started it ends.

    Args:
        num_workers: Processes to keep.
        niceness: Added to this process's own.
        hang_timeout_s: A task that takes longer counts as a dead worker.
        cancel_grace_s: The same for a task that nobody waits for any more.
    """

    def __init__(
        self, num_workers: int, niceness: int, hang_timeout_s: float, cancel_grace_s: float
    ) -> None:
        super().__init__(name="engine", daemon=True)
        self._num_workers = num_workers
        self._niceness = niceness
        self._hang_timeout_s = hang_timeout_s
        self._cancel_grace_s = cancel_grace_s
        self._requests: SimpleQueue[LocalBatch[Any] | DropBatch | None] = SimpleQueue()
        self._wake_reader, self._wake_writer = Pipe(duplex=False)
        self._workers: list[WorkerHandle] = []
        self._batches: dict[int, LocalBatch[Any]] = {}
        self._turns: deque[int] = deque()
        self._num_failed_starts = 0
        self._failure = ""

    def request(self, request: LocalBatch[Any] | DropBatch | None) -> None:
        """Enqueue a batch, a cancellation, or None for the end; from any thread."""
        self._requests.put(request)
        self._wake_writer.send_bytes(b"!")

    @property
    def pids(self) -> list[int]:
        """Process ids of the workers."""
        return [worker.pid for worker in self._workers]

    @property
    def has_failed(self) -> bool:
        """Whether no worker is left and no other will be started."""
        return bool(self._failure)

    def run(self) -> None:
        """Serve until the end is requested."""
        reason = "the engine has been closed"
        try:
            self._serve()
        except Exception as error:  # nobody may wait for results for ever
            reason = f"the engine has failed ({type(error).__name__}: {error})"
        while not self._requests.empty():
            request = self._requests.get()
            if isinstance(request, LocalBatch):
                request.abandon(reason)
        for batch in self._batches.values():
            batch.abandon(reason)
        for worker in self._workers:
            worker.kill()
            worker.end()

    def _serve(self) -> None:
        for _ in range(self._num_workers):
            self._workers.append(self._start_worker())
        while self._read_requests():
            self._hand_out()
            connections = [worker.connection for worker in self._workers]
            ready = wait([self._wake_reader, *connections], timeout=_TICK_S)
            for worker in list(self._workers):
                if worker.connection in ready:
                    self._read(worker)
            self._kill_hung()

    def _read_requests(self) -> bool:
        while self._wake_reader.poll():
            self._wake_reader.recv_bytes()
        while not self._requests.empty():
            request = self._requests.get()
            if request is None:
                return False
            if isinstance(request, DropBatch):
                self._drop(request)
            elif self._failure:
                request.abandon(self._failure)
            else:
                self._batches[request.batch_id] = request
                self._turns.append(request.batch_id)
        return True

    def _drop(self, request: DropBatch) -> None:
        self._batches.pop(request.batch_id, None)
        for worker in self._workers:
            if any(task.key.batch_id == request.batch_id for task in worker.assigned):
                worker.send(request)
                if worker.assigned[0].key.batch_id == request.batch_id:
                    worker.hurry(self._cancel_grace_s)

    def _hand_out(self) -> None:
        """One task to each idle worker, then one ahead, so that none waits for the next."""
        for depth in (1, 2):
            for worker in self._workers:
                task = self._next_task() if len(worker.assigned) < depth else None
                if task is not None and not worker.take(task):
                    self._batches[task.key.batch_id].pending.appendleft(task)

    def _next_task(self) -> RunTask | None:
        for _ in range(len(self._turns)):
            batch = self._batches.get(self._turns[0])
            if batch is None:
                self._turns.popleft()
                continue
            self._turns.rotate(-1)
            if batch.pending:
                return batch.pending.popleft()
        return None

    def _read(self, worker: WorkerHandle) -> None:
        try:
            while worker.connection.poll():
                message: Ready | Finished = worker.connection.recv()
                if isinstance(message, Ready):
                    worker.note_ready()
                    self._num_failed_starts = 0
                else:
                    self._finish(worker, message)
        except (EOFError, OSError):
            self._replace(worker)

    def _finish(self, worker: WorkerHandle, message: Finished) -> None:
        worker.note_finished()
        batch_id, index = message.key
        batch = self._batches.get(batch_id)
        if batch is not None:
            num_attempts = batch.num_deaths.get(index, 0) + 1
            batch.deliver(index, message.outcome, message.error, num_attempts)
            if batch.is_delivered:
                del self._batches[batch_id]

    def _replace(self, worker: WorkerHandle) -> None:
        """Start another worker; retry what the dead one was doing, once."""
        reason = worker.end()
        self._workers.remove(worker)
        for task in reversed(worker.assigned):
            batch = self._batches.get(task.key.batch_id)
            if batch is None:
                continue
            is_suspect = worker.is_ready and task is worker.assigned[0]
            num_deaths = batch.num_deaths.get(task.key.task_index, 0) + is_suspect
            batch.num_deaths[task.key.task_index] = num_deaths
            if num_deaths < MAX_ATTEMPTS:
                batch.pending.appendleft(task)
            else:
                text = f"task {task.key.task_index}: {num_deaths} workers died under it ({reason})"
                batch.deliver(task.key.task_index, None, text, num_deaths)
        self._num_failed_starts += not worker.is_ready
        if self._num_failed_starts < MAX_FAILED_STARTS:
            self._workers.append(self._start_worker())
        elif not self._workers:
            self._give_up(reason)

    def _start_worker(self) -> WorkerHandle:
        return WorkerHandle(self._niceness, self._hang_timeout_s)

    def _give_up(self, reason: str) -> None:
        self._failure = f"worker processes end before they are ready ({reason})"
        for batch in self._batches.values():
            batch.abandon(self._failure)
        self._batches.clear()

    def _kill_hung(self) -> None:
        now = time.monotonic()
        for worker in self._workers:
            if worker.deadline < now:
                worker.kill()  # its connection ends, and `_read` replaces it
                worker.deadline = float("inf")
