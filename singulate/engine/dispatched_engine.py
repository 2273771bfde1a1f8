"""What engines have in common that a thread serves: its dispatcher."""

import itertools
import pickle
import threading
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any, Protocol, Self, TypeVar

from singulate.engine.interface import EngineError
from singulate.engine.messages import DropBatch, RunTask, TaskKey
from singulate.engine.queued_batch import QueuedBatch
from singulate.exceptions import InvalidValueError

ToolT = TypeVar("ToolT")
TaskT = TypeVar("TaskT")
ResultT = TypeVar("ResultT")

MAX_WORKERS = 256


class DispatcherThread(Protocol):
    """A thread that owns workers."""

    def request(self, request: QueuedBatch[Any] | DropBatch | None) -> None:
        """Enqueue a batch, a cancellation, or None for the end; from any thread."""
        ...

    def start(self) -> None:
        """See `threading.Thread.start`."""
        ...

    def is_alive(self) -> bool:
        """See `threading.Thread.is_alive`."""
        ...

    def join(self) -> None:
        """See `threading.Thread.join`."""
        ...


class DispatchedEngine:
    """An `Engine` whose callers only enqueue.

    Args:
        num_workers: Workers that the dispatcher keeps.
        dispatcher: The thread, not started.
    """

    def __init__(self, num_workers: int, dispatcher: DispatcherThread) -> None:
        self._num_workers = num_workers
        self._batch_ids = itertools.count()
        self._lock = threading.Lock()
        self._is_closed = False
        self._thread = dispatcher
        dispatcher.start()

    @property
    def num_workers(self) -> int:
        """Tasks that can run at the same time."""
        return self._num_workers

    def submit(
        self,
        work: Callable[[ToolT, TaskT], ResultT],
        tasks: Sequence[TaskT],
        tool: Callable[[], ToolT],
    ) -> QueuedBatch[ResultT]:
        """Queue tasks; see `Engine.submit`."""
        work_bytes, tool_bytes = pickle.dumps(work), pickle.dumps(tool)
        batch_id = next(self._batch_ids)
        messages = [
            RunTask(TaskKey(batch_id, index), work_bytes, tool_bytes, pickle.dumps(task))
            for index, task in enumerate(tasks)
        ]
        batch: QueuedBatch[ResultT] = QueuedBatch(batch_id, messages, self._cancel)
        with self._lock:
            if self._is_closed or not self._thread.is_alive():
                raise EngineError("the engine has been closed or has failed")
            if messages:
                self._thread.request(batch)
        return batch

    def close(self) -> None:
        """Cancel everything and end the workers; may be called twice."""
        with self._lock:
            if self._is_closed:
                return
            self._is_closed = True
            self._thread.request(None)
        self._thread.join()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()

    def _cancel(self, batch_id: int) -> None:
        with self._lock:
            if not self._is_closed:
                self._thread.request(DropBatch(batch_id))


def check_workers(num_workers: int, niceness: int) -> None:
    """Check what every engine is asked for.

    Raises:
        InvalidValueError: If a value is out of range.
    """
    if not 1 <= num_workers <= MAX_WORKERS:
        raise InvalidValueError("num_workers", num_workers, f"1 to {MAX_WORKERS}")
    if not 0 <= niceness <= 19:
        raise InvalidValueError("niceness", niceness, "0 to 19")
