"""Options that hold several values."""

import json
import re
from typing import Any

from singulate.exceptions import InvalidValueError

MAX_SEEDS = 10_000


def parse_names(key: str, text: str) -> list[str]:
    """Names with commas between them, each once.

    Raises:
        InvalidValueError: If one is empty.

    Example:
        >>> parse_names("agents", "dqn,ppo")
        ['dqn', 'ppo']
    """
    names = [name.strip() for name in text.split(",")]
    if not all(names):
        raise InvalidValueError(key, text, "names with commas between them")
    return list(dict.fromkeys(names))


def parse_seeds(key: str, text: str) -> list[int]:
    """Seeds and ranges of seeds, each once.

    Raises:
        InvalidValueError: If it is something else, or more than 10,000 seeds.

    Example:
        >>> parse_seeds("seeds", "0-2,7")
        [0, 1, 2, 7]
    """
    seeds: list[int] = []
    for part in text.split(","):
        match = re.fullmatch(r"\s*(\d{1,18})(?:-(\d{1,18}))?\s*", part)
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (1, 0)
        if not first <= last < first + MAX_SEEDS:
            raise InvalidValueError(key, text, "such as 0,1,2 or 0-4")
        seeds += range(first, last + 1)
    return list(dict.fromkeys(seeds))


def parse_setting(option: str, text: str) -> tuple[str, Any]:
    """A name and its value: JSON, or else the text itself.

    Raises:
        InvalidValueError: If there is no equals sign.

    Example:
        >>> parse_setting("--set", "net_arch=[64, 32]")
        ('net_arch', [64, 32])
    """
    key, equals, value = text.partition("=")
    if not equals:
        raise InvalidValueError(option, text, "KEY=VALUE")
    try:
        return key, json.loads(value)
    except (ValueError, RecursionError):
        return key, value
