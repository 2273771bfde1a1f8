"""Doing nothing when nothing changed, and not too often when it did."""

import numpy as np


class Watch:
    """Tells whether some parts of a snapshot differ from the last time it was asked.

    Arrays count as the same only if they are the same object: nobody compares pixels.
    """

    def __init__(self) -> None:
        self._parts: tuple[object, ...] | None = None

    def has_changed(self, *parts: object) -> bool:
        """Compare with the parts of the last call, and keep these."""
        before, self._parts = self._parts, parts
        return (
            before is None
            or len(before) != len(parts)
            or any(not _same(a, b) for a, b in zip(before, parts, strict=True))
        )


def _same(a: object, b: object) -> bool:
    if a is b:
        return True
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return False
    return type(a) is type(b) and bool(a == b)


class Throttle:
    """Lets one call through each interval.

    Args:
        interval: Shortest time between two calls that are let through [s].
    """

    def __init__(self, interval: float) -> None:
        self._interval = interval
        self._next = float("-inf")

    def is_due(self, now: float) -> bool:
        """Whether the interval has passed at time `now` [s]; if so, a new one begins."""
        if now < self._next:
            return False
        self._next = now + self._interval
        return True
