"""The one thread that talks to the local workers."""

import threading
import time
from multiprocessing import Pipe
from multiprocessing.connection import wait
from queue import SimpleQueue
from typing import Any

from singulate.engine.messages import DropBatch, Finished, Ready
from singulate.engine.queued_batch import QueuedBatch
from singulate.engine.task_queue import TaskQueue
from singulate.engine.worker_handle import WorkerHandle

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
        self._requests: SimpleQueue[QueuedBatch[Any] | DropBatch | None] = SimpleQueue()
        self._wake_reader, self._wake_writer = Pipe(duplex=False)
        self._workers: list[WorkerHandle] = []
        self._queue = TaskQueue()
        self._num_failed_starts = 0
        self._failure = ""

    def request(self, request: QueuedBatch[Any] | DropBatch | None) -> None:
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
            if isinstance(request, QueuedBatch):
                request.abandon(reason)
        self._queue.abandon(reason)
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
                self._queue.add(request)
        return True

    def _drop(self, request: DropBatch) -> None:
        self._queue.drop(request.batch_id)
        for worker in self._workers:
            if any(task.key.batch_id == request.batch_id for task in worker.assigned):
                worker.send(request)
                if worker.assigned[0].key.batch_id == request.batch_id:
                    worker.hurry(self._cancel_grace_s)

    def _hand_out(self) -> None:
        """One task to each idle worker, then one ahead, so that none waits for the next."""
        for depth in (1, 2):
            for worker in self._workers:
                task = self._queue.next_task() if len(worker.assigned) < depth else None
                if task is not None and not worker.take(task):
                    self._queue.put_back(task)

    def _read(self, worker: WorkerHandle) -> None:
        try:
            while worker.connection.poll():
                message: Ready | Finished = worker.connection.recv()
                if isinstance(message, Ready):
                    worker.note_ready()
                    self._num_failed_starts = 0
                else:
                    worker.note_finished()
                    self._queue.finish(*message)
        except (EOFError, OSError):
            self._replace(worker)

    def _replace(self, worker: WorkerHandle) -> None:
        """Start another worker; retry what the dead one was doing, once."""
        reason = worker.end()
        self._workers.remove(worker)
        for task in reversed(worker.assigned):
            is_suspect = worker.is_ready and task is worker.assigned[0]
            self._queue.note_death(task, is_suspect, reason)
        self._num_failed_starts += not worker.is_ready
        if self._num_failed_starts < MAX_FAILED_STARTS:
            self._workers.append(self._start_worker())
        elif not self._workers:
            self._give_up(reason)

    def _start_worker(self) -> WorkerHandle:
        return WorkerHandle(self._niceness, self._hang_timeout_s)

    def _give_up(self, reason: str) -> None:
        self._failure = f"worker processes end before they are ready ({reason})"
        self._queue.abandon(self._failure)

    def _kill_hung(self) -> None:
        now = time.monotonic()
        for worker in self._workers:
            if worker.deadline < now:
                worker.kill()  # its connection ends, and `_read` replaces it
                worker.deadline = float("inf")
