"""Where every child process begins."""

import importlib
import signal
import sys
import traceback
from dataclasses import dataclass

from app.processes.pipes import Pipe
from singulate.engine.parent_death import die_with_parent
from singulate.engine.standing_back import stand_back


@dataclass(frozen=True)
class ChildFailed:
    """The last message of a child that an exception has ended: why, in one line."""

    reason: str


def run_child(
    connection: Pipe,
    parent_pid: int,
    target: str,
    niceness: int,
    arguments: tuple[object, ...],
) -> None:
    """Prepare a spawned process and run its function until its pipe is closed.

    Args:
        connection: Pipe to the parent, passed on to the function.
        parent_pid: The parent; this process does not outlive it.
        target: ``module:function``, named and not passed, so that the parent imports none of it.
        niceness: Added to the process's niceness; the higher, the more it yields to others.
        arguments: Further arguments of the function.
    """
    die_with_parent(parent_pid)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    stand_back(niceness)
    module_name, _, function_name = target.partition(":")
    try:
        getattr(importlib.import_module(module_name), function_name)(connection, *arguments)
    except (EOFError, BrokenPipeError, ConnectionResetError):
        return
    except Exception as error:
        traceback.print_exc(file=sys.stderr)
        line = str(error).strip().splitlines()
        connection.send(ChildFailed(f"{type(error).__name__}: {line[0] if line else ''}"))
        sys.exit(1)
