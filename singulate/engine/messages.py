"""What the engine and a local worker say to each other over their pipe."""

from typing import NamedTuple


class TaskKey(NamedTuple):
    """Which task of which batch."""

    batch_id: int
    task_index: int


class RunTask(NamedTuple):
    """Engine to worker: run this; all parts are pickled."""

    key: TaskKey
    work: bytes
    tool: bytes
    task: bytes

    @property
    def num_bytes(self) -> int:
        """Size on the pipe, roughly."""
        return len(self.work) + len(self.tool) + len(self.task)


class DropBatch(NamedTuple):
    """Engine to worker: forget tasks of this batch that have not begun."""

    batch_id: int


class Ready(NamedTuple):
    """Worker to engine: started and listening."""

    pid: int


class Finished(NamedTuple):
    """Worker to engine: a task has ended or was dropped; `error` is one line."""

    key: TaskKey
    outcome: object
    error: str | None
