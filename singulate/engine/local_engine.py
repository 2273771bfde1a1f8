"""Worker processes on this machine."""

import itertools
import os
import pickle
import threading
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Self, TypeVar

from singulate.engine.dispatcher import Dispatcher
from singulate.engine.interface import EngineError
from singulate.engine.local_batch import LocalBatch
from singulate.engine.messages import DropBatch, RunTask, TaskKey
from singulate.exceptions import InvalidValueError

ToolT = TypeVar("ToolT")
TaskT = TypeVar("TaskT")
ResultT = TypeVar("ResultT")

MAX_WORKERS = 256


class LocalEngine:
    """An `Engine` of spawned, niced, watched processes that die with this one.

    Args:
        num_workers: Processes; one a core by default.
        niceness: How far the workers stand back behind this process (0 to 19).
        hang_timeout_s: A worker that takes longer over one task is replaced, like a dead one.
        cancel_grace_s: A worker that is still busy with a cancelled task after this is replaced.

    Raises:
        InvalidValueError: If a value is out of range.

    Example:
        >>> import operator
        >>> with LocalEngine(num_workers=1) as engine:
        ...     batch = engine.submit(operator.add, [1, 2], tool=int)
        ...     sorted(result.value for result in batch)
        [1, 2]
    """

    def __init__(
        self,
        num_workers: int | None = None,
        *,
        niceness: int = 15,
        hang_timeout_s: float = 120.0,
        cancel_grace_s: float = 10.0,
    ) -> None:
        if num_workers is None:
            num_workers = os.cpu_count() or 1
        if not 1 <= num_workers <= MAX_WORKERS:
            raise InvalidValueError("num_workers", num_workers, f"1 to {MAX_WORKERS}")
        if not 0 <= niceness <= 19:
            raise InvalidValueError("niceness", niceness, "0 to 19")
        self._num_workers = num_workers
        self._batch_ids = itertools.count()
        self._lock = threading.Lock()
        self._is_closed = False
        self._dispatcher = Dispatcher(num_workers, niceness, hang_timeout_s, cancel_grace_s)
        self._dispatcher.start()

    @property
    def num_workers(self) -> int:
        """Tasks that can run at the same time."""
        return self._num_workers

    @property
    def pids(self) -> list[int]:
        """Process ids of the workers; a replaced one has another."""
        return self._dispatcher.pids

    @property
    def has_failed(self) -> bool:
        """Whether it refuses all work for good, because its workers end before they are ready."""
        return self._dispatcher.has_failed

    def submit(
        self,
        work: Callable[[ToolT, TaskT], ResultT],
        tasks: Sequence[TaskT],
        tool: Callable[[], ToolT],
    ) -> LocalBatch[ResultT]:
        """Queue tasks; see `Engine.submit`."""
        work_bytes, tool_bytes = pickle.dumps(work), pickle.dumps(tool)
        batch_id = next(self._batch_ids)
        messages = [
            RunTask(TaskKey(batch_id, index), work_bytes, tool_bytes, pickle.dumps(task))
            for index, task in enumerate(tasks)
        ]
        batch: LocalBatch[ResultT] = LocalBatch(batch_id, messages, self._cancel)
        with self._lock:
            if self._is_closed or not self._dispatcher.is_alive():
                raise EngineError("the engine has been closed or has failed")
            if messages:
                self._dispatcher.request(batch)
        return batch

    def close(self) -> None:
        """Cancel everything and end the workers; may be called twice."""
        with self._lock:
            if self._is_closed:
                return
            self._is_closed = True
            self._dispatcher.request(None)
        self._dispatcher.join()

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
                self._dispatcher.request(DropBatch(batch_id))
