"""One measured number, and what to measure."""

import math
from dataclasses import dataclass

from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class Measurement:
    """A number that a benchmark has found.

    Attributes:
        name: What was measured, unique within the benchmark.
        value: How much.
        unit: Of what; empty for ratios.
        note: What exactly was compared or counted.
    """

    name: str
    value: float
    unit: str
    note: str = ""


@dataclass(frozen=True)
class BenchOptions:
    """What all benchmarks understand.

    Attributes:
        seconds: Time for each measurement that is taken by the clock [s].
        num_repeats: Scenes, clicks or runs behind a median.
        num_workers: Worker processes; one a core by default.

    Raises:
        InvalidValueError: If a value is out of range.
    """

    seconds: float = 5.0
    num_repeats: int = 3
    num_workers: int | None = None

    def __post_init__(self) -> None:
        if not (math.isfinite(self.seconds) and 0.0 < self.seconds <= 3600.0):
            raise InvalidValueError("seconds", self.seconds, "more than 0, at most 3600")
        if not 1 <= self.num_repeats <= 1000:
            raise InvalidValueError("repeats", self.num_repeats, "1 to 1000")
