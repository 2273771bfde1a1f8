"""A claim of the paper and what became of it."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

HELD, PARTLY, NOT_HELD = "held", "partly", "not held"
NOT_MEASURED = "not measured"


@dataclass(frozen=True)
class Numbers:
    """One measured quantity over seeds.

    Attributes:
        name: What it is.
        values: One a seed.
    """

    name: str
    values: tuple[float, ...]

    @classmethod
    def of(cls, name: str, values: Sequence[float]) -> "Numbers":
        """Rounded, so that tables and JSON say the same."""
        return cls(name, tuple(round(float(value), 4) for value in values))

    @property
    def median(self) -> float:
        """Median over seeds."""
        return float(np.median(self.values))

    @property
    def text(self) -> str:
        """Median, range and number of seeds."""
        low, high = min(self.values), max(self.values)
        spread = f"{low:.3g} to {high:.3g}, {len(self.values)} seeds"
        return f"{self.name}: {self.median:.3g} ({spread})"


@dataclass(frozen=True)
class Claim:
    """One row of the table.

    Attributes:
        key: Stable name.
        statement: What the paper says, in our words.
        source: Where it says so.
        measure: What was measured, and the rule that decides.
        verdict: `HELD`, `PARTLY`, `NOT_HELD` or `NOT_MEASURED`.
        numbers: What came out.
        note: Length of the trainings and the like.
        reason: Likely reason where it does not hold, or what is missing where it is not measured.
    """

    key: str
    statement: str
    source: str
    measure: str
    verdict: str = NOT_MEASURED
    numbers: tuple[Numbers, ...] = ()
    note: str = ""
    reason: str = field(default="", kw_only=True)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON, with medians."""
        numbers = [{**asdict(each), "median": each.median} for each in self.numbers]
        return {**asdict(self), "numbers": numbers}


def compare(better: Sequence[float], worse: Sequence[float]) -> str:
    """Verdict on "this is better than that" from one number a seed.

    Held where even the worst seed of the one beats the best of the other; partly where only the
    medians are in that order.

    Example:
        >>> compare([0.5, 0.6, 0.7], [0.1, 0.2, 0.4]), compare([0.1, 0.6, 0.7], [0.1, 0.2, 0.4])
        ('held', 'partly')
    """
    if min(better) > max(worse):
        return HELD
    return PARTLY if np.median(better) > np.median(worse) else NOT_HELD


def both(one: str, other: str) -> str:
    """Verdict on two statements in one: held where both are, partly where something of them is.

    Example:
        >>> both("held", "not held"), both("held", "held")
        ('partly', 'held')
    """
    verdicts = {one, other}
    return verdicts.pop() if len(verdicts) == 1 else PARTLY


def at_least(values: Sequence[float], full: float, part: float) -> str:
    """Verdict on "this reaches `full`": held where the median does, partly where it reaches `part`.

    Example:
        >>> at_least([0.8, 0.95, 0.99], 0.9, 0.5), at_least([0.1, 0.2, 0.9], 0.9, 0.5)
        ('held', 'not held')
    """
    median = float(np.median(values))
    return HELD if median >= full else PARTLY if median >= part else NOT_HELD


def at_most(values: Sequence[float], full: float, part: float) -> str:
    """Verdict on "this stays below `full`", the other way round."""
    median = float(np.median(values))
    return HELD if median <= full else PARTLY if median <= part else NOT_HELD
