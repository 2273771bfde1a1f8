"""What every engine does, whether its workers are local processes or a cluster's.

A task is pure: its result depends on the task alone. So it may run in any worker, in any order, and
once more after a worker has died. The *tool* is what a worker needs for its tasks and is costly to
build, such as a Bullet scene: each worker builds one on its first task and keeps it, and a task
must not be able to tell which tasks the tool has served before.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Generic, Protocol, Self, TypeVar

from singulate.exceptions import SingulateError

ToolT = TypeVar("ToolT")
TaskT = TypeVar("TaskT")
ResultT = TypeVar("ResultT")


class EngineError(SingulateError):
    """A task failed, its worker died twice, or workers cannot be started."""


@dataclass(frozen=True)
class TaskResult(Generic[ResultT]):
    """The end of one task.

    Attributes:
        index: Position of the task in the batch.
        error: Why there is no value, one line; None if there is one.
        num_attempts: Workers that have tried it.
    """

    index: int
    outcome: ResultT | None
    error: str | None = None
    num_attempts: int = 1

    @property
    def value(self) -> ResultT:
        """What the task returned.

        Raises:
            EngineError: If the task failed.
        """
        if self.error is not None:
            raise EngineError(self.error)
        return self.outcome  # type: ignore[return-value]


class Batch(Protocol[ResultT]):
    """Tasks that were submitted together and are cancelled together."""

    @property
    def num_tasks(self) -> int:
        """Tasks in the batch."""
        ...

    @property
    def is_done(self) -> bool:
        """Whether no further result will come: all were delivered, or it was cancelled."""
        ...

    def poll(self, timeout_s: float | None = None) -> TaskResult[ResultT] | None:
        """Next finished task in order of completion; None after the timeout or when done."""
        ...

    def __iter__(self) -> Iterator[TaskResult[ResultT]]:
        """Finished tasks in order of completion, until `is_done`."""
        ...

    def cancel(self) -> None:
        """Drop all tasks that have not finished; returns at once; harmless when done."""
        ...


class Engine(Protocol):
    """A pool of workers; closing it cancels everything and ends them."""

    @property
    def num_workers(self) -> int:
        """Tasks that can run at the same time."""
        ...

    def submit(
        self,
        work: Callable[[ToolT, TaskT], ResultT],
        tasks: Sequence[TaskT],
        tool: Callable[[], ToolT],
    ) -> Batch[ResultT]:
        """Queue tasks; batches take turns, so a long one does not hold up a short one.

        Args:
            work: Importable function that is called as ``work(tool, task)`` in a worker.
            tasks: One picklable value a task.
            tool: Picklable factory of what the worker keeps between tasks. Factories that pickle
                to the same bytes share a tool. A tool's ``close()``, if any, is called when it is
                no longer kept.

        Returns:
            The batch, at once. A task that raises is reported and not retried; a task whose worker
            dies is retried once in a fresh worker, then reported.

        Raises:
            EngineError: If the engine is closed.
        """
        ...

    def close(self) -> None:
        """Cancel everything and end the workers; may be called twice."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None: ...
