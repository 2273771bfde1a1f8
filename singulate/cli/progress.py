"""Progress bars for people; silent where standard error is no terminal."""

import sys
import time
from contextlib import ExitStack
from types import TracebackType
from typing import TYPE_CHECKING, Self

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

if TYPE_CHECKING:
    from singulate.training.links import Progress as TrainingProgress

MIN_INTERVAL_S = 0.1


class CountBar:
    """A bar with a count, time left and a note; a context manager.

    Args:
        text: What is being done.
        total: How much there is of it.
    """

    def __init__(self, text: str, total: int) -> None:
        self._bar = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
            TextColumn("{task.fields[note]}"),
            console=Console(stderr=True),
            disable=not sys.stderr.isatty(),
            transient=True,
        )
        self._task = self._bar.add_task(text, total=total, note="")
        self._last = 0.0

    def set(self, done: int, note: str = "") -> None:
        """Show how much is done; cheap enough for every push."""
        now = time.monotonic()
        if now - self._last >= MIN_INTERVAL_S:
            self._last = now
            self._bar.update(self._task, completed=done, note=note)

    def __enter__(self) -> Self:
        self._bar.start()
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._bar.stop()


class StepBars:
    """One bar after another, for work in steps; a context manager."""

    def __init__(self) -> None:
        self._stack = ExitStack()
        self._bar: CountBar | None = None
        self._step = ""

    def show(self, step: str, done: int, total: int) -> None:
        """Show how far a step is; a new one ends the last one's bar."""
        if self._bar is None or step != self._step:
            self._stack.close()
            self._bar = self._stack.enter_context(CountBar(step, total))
            self._step = step
        self._bar.set(done)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()


class TrainingBar(CountBar):
    """The bar of a training.

    Args:
        total: Pushes to train for.
    """

    def __init__(self, total: int) -> None:
        super().__init__("Training", total)

    def update(self, progress: "TrainingProgress") -> None:
        """Show how far a training is."""
        self.set(
            progress.num_steps,
            f"{progress.success_rate:.0%} success, {progress.pushes_per_second:.0f} pushes/s",
        )
