"""Which task is next, and what becomes of tasks whose workers die: the same for every engine."""

from collections import deque
from typing import Any

from singulate.engine.messages import RunTask, TaskKey
from singulate.engine.queued_batch import QueuedBatch

MAX_ATTEMPTS = 2
"""Workers that may die under a task before it is reported."""


class TaskQueue:
    """The batches that are under way; touched by the engine's thread alone."""

    def __init__(self) -> None:
        self._batches: dict[int, QueuedBatch[Any]] = {}
        self._turns: deque[int] = deque()

    def add(self, batch: QueuedBatch[Any]) -> None:
        """Queue a batch."""
        self._batches[batch.batch_id] = batch
        self._turns.append(batch.batch_id)

    def drop(self, batch_id: int) -> None:
        """Forget a batch."""
        self._batches.pop(batch_id, None)

    def next_task(self) -> RunTask | None:
        """Take a task; batches take turns."""
        for _ in range(len(self._turns)):
            batch = self._batches.get(self._turns[0])
            if batch is None:
                self._turns.popleft()
                continue
            self._turns.rotate(-1)
            if batch.pending:
                return batch.pending.popleft()
        return None

    def put_back(self, task: RunTask) -> None:
        """Return a task that could not be handed out."""
        batch = self._batches.get(task.key.batch_id)
        if batch is not None:
            batch.pending.appendleft(task)

    def finish(self, key: TaskKey, outcome: object, error: str | None) -> None:
        """Deliver the end of a task, unless its batch was dropped."""
        batch = self._batches.get(key.batch_id)
        if batch is not None:
            num_attempts = batch.num_deaths.get(key.task_index, 0) + 1
            self._deliver(batch, key.task_index, outcome, error, num_attempts)

    def note_death(self, task: RunTask, is_suspect: bool, reason: str) -> None:
        """A worker has died that held a task: retry it, or report it.

        Args:
            task: What the worker was given.
            is_suspect: Whether the worker had begun it.
            reason: How the worker ended.
        """
        batch = self._batches.get(task.key.batch_id)
        if batch is None:
            return
        index = task.key.task_index
        num_deaths = batch.num_deaths.get(index, 0) + is_suspect
        batch.num_deaths[index] = num_deaths
        if num_deaths < MAX_ATTEMPTS:
            batch.pending.appendleft(task)
        else:
            text = f"task {index}: {num_deaths} workers died under it ({reason})"
            self._deliver(batch, index, None, text, num_deaths)

    def abandon(self, reason: str) -> None:
        """Give all batches up."""
        for batch in self._batches.values():
            batch.abandon(reason)
        self._batches.clear()

    def _deliver(
        self,
        batch: QueuedBatch[Any],
        index: int,
        outcome: object,
        error: str | None,
        num_attempts: int,
    ) -> None:
        batch.deliver(index, outcome, error, num_attempts)
        if batch.is_delivered:
            self.drop(batch.batch_id)
