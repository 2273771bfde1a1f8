"""What the page takes from a training: the page stands still and works, turn by turn."""

import signal
import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NamedTuple

import psutil

from singulate.bench.dashboard_process import pushes_per_second
from singulate.exceptions import SingulateError

_HELD_UP = 0.5
"""A page that is stopped while it reads the record holds the training up, which then falls below
this share of its usual speed."""
_MAX_TRIES = 10
_RECOVERY_S = 0.5
"""How long the page may work before it is stopped again, so that it does not stop at the same
place."""


class Tax(NamedTuple):
    """Speeds of one training with the page at work and standing still, in pairs of phases.

    Attributes:
        alone: Pushes a second while all processes of the page were stopped.
        beside: Pushes a second in the other phase of each pair, with the page at work.
    """

    alone: list[float]
    beside: list[float]

    @property
    def speed_kept(self) -> float:
        """Median of the pairs' ratios; 1 is no loss."""
        return statistics.median(self._ratios)

    @property
    def quartiles(self) -> tuple[float, float]:
        """Half of the pairs' ratios lie between these two; there are at least two pairs."""
        first, _, third = statistics.quantiles(self._ratios, n=4, method="inclusive")
        return first, third

    @property
    def _ratios(self) -> list[float]:
        pairs = zip(self.alone, self.beside, strict=True)
        return [beside / alone for alone, beside in pairs]


def measure_tax(
    run_dir: Path,
    processes: list[psutil.Process],
    seconds: float,
    num_pairs: int,
    act: Callable[[], None] = lambda: None,
) -> Tax:
    """Alternate between phases of one training, so that a machine that changes counts for neither.

    The page works first in every other pair: a training that slows down as its replay buffer fills
    hurts both alike.

    Args:
        run_dir: The training.
        processes: All processes of the page.
        seconds: Length of a phase.
        num_pairs: Phases of each kind.
        act: Called at the beginning of each phase in which the page works.

    Raises:
        SingulateError: If the training stands still again and again while the page does.
    """
    tax = Tax([], [])

    def stand_still() -> None:
        usual = statistics.median([0.0, *tax.alone, *tax.beside])
        for _ in range(_MAX_TRIES):
            with stopped(processes):
                rate = pushes_per_second(run_dir, seconds)
            if rate > _HELD_UP * usual:
                tax.alone.append(rate)
                return
            time.sleep(_RECOVERY_S)
        raise SingulateError("the training stands still whenever the page does")

    def work() -> None:
        act()
        tax.beside.append(pushes_per_second(run_dir, seconds))

    for number in range(num_pairs):
        for phase in (stand_still, work) if number % 2 == 0 else (work, stand_still):
            phase()
    return tax


def tree(pid: int) -> list[psutil.Process]:
    """A process and all below it."""
    root = psutil.Process(pid)
    return [root, *root.children(recursive=True)]


@contextmanager
def stopped(processes: list[psutil.Process]) -> Iterator[None]:
    """Keep processes from working during a block."""
    _send(processes, signal.SIGSTOP)
    try:
        yield
    finally:
        _send(processes, signal.SIGCONT)


def _send(processes: list[psutil.Process], number: signal.Signals) -> None:
    for process in processes:
        with suppress(psutil.NoSuchProcess):
            process.send_signal(number)
