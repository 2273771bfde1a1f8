"""What a worker keeps between tasks, and how it runs one."""

import pickle
from collections import OrderedDict
from collections.abc import Callable
from typing import Any

from singulate.engine.messages import Finished, RunTask

MAX_TOOLS = 3
"""Tools that a worker keeps; the one not used for longest goes first."""


class ToolBox:
    """The tools of one worker, each built on its first use."""

    def __init__(self) -> None:
        self._tools: OrderedDict[bytes, object] = OrderedDict()

    def run(self, task: RunTask) -> Finished:
        """Run a task; whatever it raises is its result, not the worker's end."""
        try:
            work: Callable[[Any, Any], object] = pickle.loads(task.work)
            outcome = work(self._get(task.tool), pickle.loads(task.task))
        except Exception as error:
            return Finished(task.key, None, one_line(error))
        return Finished(task.key, outcome, None)

    def _get(self, factory: bytes) -> object:
        """The tool of this pickled factory."""
        if factory not in self._tools:
            while len(self._tools) >= MAX_TOOLS:
                _, oldest = self._tools.popitem(last=False)
                getattr(oldest, "close", lambda: None)()
            self._tools[factory] = pickle.loads(factory)()
        self._tools.move_to_end(factory)
        return self._tools[factory]


def one_line(error: Exception) -> str:
    """Kind and text of an error."""
    return f"{type(error).__name__}: {error}".replace("\n", " ")
