"""Checks of values that arrive from browsers, which may send anything."""

from collections.abc import Callable, Iterable
from typing import TypeVar

from singulate.exceptions import InvalidValueError
from singulate.finite import is_finite_number

T_co = TypeVar("T_co", covariant=True)
Check = Callable[[object], T_co]
"""Returns a value in its proper type or raises `InvalidValueError`."""


def one_of(key: str, options: Iterable[str]) -> Callable[[object], str]:
    """A check that accepts the given texts only.

    Raises:
        InvalidValueError: By the returned check, for anything else.
    """
    allowed = tuple(options)

    def check(value: object) -> str:
        if not isinstance(value, str) or value not in allowed:
            raise InvalidValueError(key, value, ", ".join(allowed))
        return value

    return check


def number(key: str, low: float, high: float) -> Callable[[object], float]:
    """A check that accepts finite numbers in [low, high] only.

    Raises:
        InvalidValueError: By the returned check, for anything else.
    """

    def check(value: object) -> float:
        if not (is_finite_number(value) and low <= value <= high):
            raise InvalidValueError(key, value, f"a number from {low:g} to {high:g}")
        return float(value)

    return check


def whole_number(key: str, low: int, high: int) -> Callable[[object], int]:
    """A check that accepts whole numbers in [low, high] only.

    Raises:
        InvalidValueError: By the returned check, for anything else.
    """

    def check(value: object) -> int:
        is_whole = isinstance(value, int) or (isinstance(value, float) and value.is_integer())
        if isinstance(value, bool) or not is_whole or not low <= value <= high:  # type: ignore[operator]
            raise InvalidValueError(key, value, f"a whole number from {low} to {high}")
        return int(value)  # type: ignore[call-overload, no-any-return]

    return check


def flag(key: str) -> Callable[[object], bool]:
    """A check that accepts True and False only.

    Raises:
        InvalidValueError: By the returned check, for anything else.
    """

    def check(value: object) -> bool:
        if not isinstance(value, bool):
            raise InvalidValueError(key, value, "true or false")
        return value

    return check
