"""Checks that every agent's configuration shares."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any, TypeVar

from singulate.exceptions import InvalidValueError
from singulate.finite import is_finite_number

ConfigT = TypeVar("ConfigT")


def config_from_dict(
    config_class: type[ConfigT], values: Mapping[str, Any], prefix: str
) -> ConfigT:
    """Build a configuration dataclass from plain values.

    Args:
        config_class: A dataclass that checks its own values.
        values: Values by field name; absent ones keep their defaults.
        prefix: How the user knows the configuration (``agent_config``).

    Raises:
        InvalidValueError: If a key is unknown or a value is not allowed.
    """
    if not isinstance(values, Mapping):
        raise InvalidValueError(prefix, values, "a mapping of names to values")
    names = [field.name for field in fields(config_class)]  # type: ignore[arg-type]
    for key in values:
        if key not in names:
            raise InvalidValueError(f"{prefix}.{key}", values[key], "one of " + ", ".join(names))
    return config_class(**values)


def check_int(key: str, value: object, low: int, high: int = 10_000_000) -> None:
    """Raise InvalidValueError unless `value` is an integer in [low, high]."""
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        raise InvalidValueError(key, value, f"an integer from {low} to {high}")


def check_number(key: str, value: object, low: float, high: float) -> None:
    """Raise InvalidValueError unless `value` is a finite number in [low, high]."""
    if not is_finite_number(value) or not low <= value <= high:
        raise InvalidValueError(key, value, f"a number from {low:g} to {high:g}")


def check_positive(key: str, value: object, high: float) -> None:
    """Raise InvalidValueError unless `value` is a number in (0, high]."""
    check_number(key, value, 0.0, high)
    if value == 0:
        raise InvalidValueError(key, value, f"a number above 0, up to {high:g}")


def check_bool(key: str, value: object) -> None:
    """Raise InvalidValueError unless `value` is true or false."""
    if not isinstance(value, bool):
        raise InvalidValueError(key, value, "true or false")
