"""One measured number, and what to measure."""

import math
import os
from dataclasses import dataclass

from singulate.engine.dispatched_engine import MAX_WORKERS
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class Measurement:
    """A number that a benchmark has found.

    Attributes:
        name: What was measured, unique within the benchmark; of a point of a curve, the curve's
            name, which each point has once.
        value: How much; None where it could not be measured, which the note then explains.
        unit: Of what; empty for ratios.
        note: What exactly was compared or counted.
        axis: Of a point of a curve: what grows along it, such as ``blocks``; else empty.
        at: Of a point of a curve: where it is on that axis.
    """

    name: str
    value: float | None
    unit: str
    note: str = ""
    axis: str = ""
    at: float | None = None


@dataclass(frozen=True)
class BenchOptions:
    """What all benchmarks understand.

    Attributes:
        seconds: Time for each measurement that is taken by the clock [s].
        num_repeats: Scenes, clicks or runs behind a median.
        num_workers: Worker processes; one a core by default.
        num_seeds: Trainings of each agent behind a median.

    Raises:
        InvalidValueError: If a value is out of range.
    """

    seconds: float = 5.0
    num_repeats: int = 3
    num_workers: int | None = None
    num_seeds: int = 5

    def __post_init__(self) -> None:
        if not (math.isfinite(self.seconds) and 0.0 < self.seconds <= 3600.0):
            raise InvalidValueError("seconds", self.seconds, "more than 0, at most 3600")
        if not 1 <= self.num_repeats <= 1000:
            raise InvalidValueError("repeats", self.num_repeats, "1 to 1000")
        if self.num_workers is not None and not 1 <= self.num_workers <= MAX_WORKERS:
            raise InvalidValueError("workers", self.num_workers, f"1 to {MAX_WORKERS}")
        if not 1 <= self.num_seeds <= 1000:
            raise InvalidValueError("seeds", self.num_seeds, "1 to 1000")

    @property
    def worker_counts(self) -> tuple[int, ...]:
        """Numbers of workers to compare: 1, 2, 4 ... up to all.

        Example:
            >>> BenchOptions(num_workers=6).worker_counts
            (1, 2, 4, 6)
        """
        most = self.num_workers or os.cpu_count() or 1
        return (*(2**i for i in range(most.bit_length()) if 2**i < most), most)
