"""The life of a local worker process: ``python -m singulate.engine.worker FD PARENT_PID NICE``."""

import os
import pickle
import signal
import sys
from collections import OrderedDict, deque
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from singulate.engine.messages import DropBatch, Finished, Ready, RunTask
from singulate.engine.parent_death import die_with_parent

MAX_TOOLS = 3
"""Tools that a worker keeps; the one not used for longest goes first."""


def main(fd: int, parent_pid: int, niceness: int) -> None:
    """Serve tasks from the inherited socket `fd` until the parent is gone."""
    die_with_parent(parent_pid)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(niceness)
    connection = Connection(fd)
    with suppress(EOFError, BrokenPipeError, ConnectionResetError):
        sys.path[:] = connection.recv()
        connection.send(Ready(os.getpid()))
        _serve(connection)


def _serve(connection: Connection) -> None:
    tools = ToolBox()
    inbox: deque[RunTask] = deque()
    while True:
        dropped: set[int] = set()
        while not inbox or connection.poll():
            message = connection.recv()
            if isinstance(message, DropBatch):
                dropped.add(message.batch_id)
            else:
                inbox.append(message)
        task = inbox.popleft()
        if task.key.batch_id in dropped:
            connection.send(Finished(task.key, None, "cancelled"))
        else:
            _answer(connection, task, tools)


def _answer(connection: Connection, task: RunTask, tools: "ToolBox") -> None:
    try:
        work: Callable[[Any, Any], object] = pickle.loads(task.work)
        outcome = work(tools.get(task.tool), pickle.loads(task.task))
        connection.send(Finished(task.key, outcome, None))
    except (BrokenPipeError, ConnectionResetError):
        raise
    except Exception as error:  # whatever a task raises is its result, not the worker's end
        text = f"{type(error).__name__}: {error}".replace("\n", " ")
        connection.send(Finished(task.key, None, text))


class ToolBox:
    """The tools of one worker, each built on its first use."""

    def __init__(self) -> None:
        self._tools: OrderedDict[bytes, object] = OrderedDict()

    def get(self, factory: bytes) -> object:
        """The tool of this pickled factory."""
        if factory not in self._tools:
            while len(self._tools) >= MAX_TOOLS:
                _, oldest = self._tools.popitem(last=False)
                getattr(oldest, "close", lambda: None)()
            self._tools[factory] = pickle.loads(factory)()
        self._tools.move_to_end(factory)
        return self._tools[factory]


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:4]))
