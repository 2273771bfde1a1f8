"""The life of a local worker process: ``python -m singulate.engine.worker FD PARENT_PID NICE``."""

import os
import signal
import sys
from collections import deque
from contextlib import suppress
from multiprocessing.connection import Connection

from singulate.engine.messages import DropBatch, Finished, Ready, RunTask
from singulate.engine.parent_death import die_with_parent
from singulate.engine.standing_back import stand_back
from singulate.engine.tool_box import ToolBox, one_line


def main(fd: int, parent_pid: int, niceness: int) -> None:
    """Serve tasks from the inherited socket `fd` until the parent is gone."""
    die_with_parent(parent_pid)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    stand_back(niceness)
    connection = Connection(fd)
    with suppress(EOFError, BrokenPipeError, ConnectionResetError):
        sys.path[:] = connection.recv()
        connection.send(Ready(os.getpid()))
        _serve(connection)


def _serve(connection: Connection) -> None:
    tools = ToolBox()
    inbox: deque[RunTask] = deque()
    while True:
        while not inbox or connection.poll():
            message = connection.recv()
            if isinstance(message, DropBatch):
                _drop(connection, inbox, message.batch_id)
            else:
                inbox.append(message)
        _answer(connection, inbox.popleft(), tools)


def _drop(connection: Connection, inbox: deque[RunTask], batch_id: int) -> None:
    """Answer all waiting tasks of a batch without running them; no more of it will come."""
    for task in [task for task in inbox if task.key.batch_id == batch_id]:
        inbox.remove(task)
        connection.send(Finished(task.key, None, "cancelled"))


def _answer(connection: Connection, task: RunTask, tools: ToolBox) -> None:
    finished = tools.run(task)
    try:
        connection.send(finished)
    except (BrokenPipeError, ConnectionResetError):
        raise
    except Exception as error:  # the outcome cannot be pickled
        connection.send(Finished(task.key, None, one_line(error)))


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:4]))
