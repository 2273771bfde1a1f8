"""A batch whose results come from a thread of its engine."""

from collections import deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import Generic, TypeVar, cast

from singulate.engine.interface import EngineError, TaskResult
from singulate.engine.messages import RunTask

ResultT = TypeVar("ResultT")


class QueuedBatch(Generic[ResultT]):
    """Results travel from the engine's thread to the caller through a queue.

    Args:
        tasks: The tasks in their order.
        on_cancel: Tells the engine.

    Attributes:
        pending: Tasks that wait for a worker; only the engine's thread touches it.
        num_deaths: Workers that died under a task, by index; only the engine's thread touches it.
    """

    def __init__(
        self, batch_id: int, tasks: list[RunTask], on_cancel: Callable[[int], None]
    ) -> None:
        self.batch_id = batch_id
        self.pending = deque(tasks)
        self.num_deaths: dict[int, int] = {}
        self._num_tasks = len(tasks)
        self._num_returned = 0
        self._num_delivered = 0
        self._is_cancelled = False
        self._failure: str | None = None
        self._on_cancel = on_cancel
        self._results: SimpleQueue[TaskResult[ResultT] | None] = SimpleQueue()

    @property
    def num_tasks(self) -> int:
        """Tasks in the batch."""
        return self._num_tasks

    @property
    def is_done(self) -> bool:
        """Whether no further result will come."""
        return self._is_cancelled or self._num_returned == self._num_tasks

    @property
    def is_delivered(self) -> bool:
        """Whether all results are in the caller's queue; for the engine's thread."""
        return self._num_delivered == self._num_tasks

    def poll(self, timeout_s: float | None = None) -> TaskResult[ResultT] | None:
        """Next finished task in order of completion; None after the timeout or when done.

        Raises:
            EngineError: If the engine was closed or cannot start workers.
        """
        result = None
        if not self.is_done:
            with suppress(Empty):
                result = self._results.get(timeout=timeout_s)
        if self._failure is not None:
            raise EngineError(self._failure)
        if result is None or self._is_cancelled:
            return None
        self._num_returned += 1
        return result

    def __iter__(self) -> Iterator[TaskResult[ResultT]]:
        """Finished tasks in order of completion, until `is_done`."""
        while not self.is_done:
            result = self.poll()
            if result is not None:
                yield result

    def cancel(self) -> None:
        """Drop all tasks that have not finished; returns at once."""
        if not self.is_done:
            self._on_cancel(self.batch_id)
            self.abandon()

    def abandon(self, failure: str | None = None) -> None:
        """Deliver nothing more and release whoever waits; a failure is raised there."""
        if self.is_done:
            return
        self._failure = failure
        self._is_cancelled = True
        self._results.put(None)

    def deliver(self, index: int, outcome: object, error: str | None, num_attempts: int) -> None:
        """Hand a finished task to the caller."""
        self._num_delivered += 1
        value = cast("ResultT | None", outcome)
        self._results.put(TaskResult(index, value, error, num_attempts))
