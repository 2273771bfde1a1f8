"""A worker on a Ray cluster: an actor that keeps its tools between tasks."""

import os
import sys
import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

import ray

from singulate.engine.messages import Finished, Ready, RunTask
from singulate.engine.tool_box import ToolBox


class RayWorker:
    """The actor's side.

    Args:
        path: The engine's ``sys.path``: what the engine can import, tasks can.
        niceness: Added to the node's own.
    """

    def __init__(self, path: list[str], niceness: int) -> None:
        sys.path += [entry for entry in path if entry not in sys.path]
        os.nice(niceness)
        self._tools = ToolBox()

    def start(self) -> Ready:
        """Answer as soon as the worker lives."""
        return Ready(os.getpid())

    def run(self, task: RunTask) -> Finished:
        """Run a task."""
        return self._tools.run(task)


class RayWorkerHandle:
    """The engine's side.

    Args:
        niceness: Added to the node's own.
        hang_timeout_s: A task that takes longer counts as hung.
        on_answer: Called with this handle and an answer, from a thread of Ray's.

    Attributes:
        is_ready: Whether it has ever answered.
        task: What it is doing; None while it is idle.
        deadline: When its task counts as hung, by `time.monotonic` [s].
    """

    def __init__(
        self,
        niceness: int,
        hang_timeout_s: float,
        on_answer: Callable[["RayWorkerHandle", Future[Any]], None],
    ) -> None:
        self._hang_timeout_s = hang_timeout_s
        self._on_answer = on_answer
        self.is_ready = False
        self.task: RunTask | None = None
        self.deadline = float("inf")
        options = {"num_cpus": 1, "max_restarts": 0, "scheduling_strategy": "SPREAD"}
        actor_class: Any = ray.remote(RayWorker)
        self._actor = actor_class.options(**options).remote(list(sys.path), niceness)
        self._listen(self._actor.start.remote())

    def take(self, task: RunTask) -> None:
        """Send a task to an idle worker."""
        self.task = task
        self.deadline = time.monotonic() + self._hang_timeout_s
        self._listen(self._actor.run.remote(task))

    def note_finished(self) -> None:
        """Its task has ended."""
        self.task = None
        self.deadline = float("inf")

    def hurry(self, grace_s: float) -> None:
        """Bring the deadline of a running task forward."""
        self.deadline = min(self.deadline, time.monotonic() + grace_s)

    def kill(self) -> None:
        """End it at once; an answer that is still expected becomes an error."""
        ray.kill(self._actor)

    def _listen(self, answer: "ray.ObjectRef[Any]") -> None:
        answer.future().add_done_callback(lambda future: self._on_answer(self, future))
