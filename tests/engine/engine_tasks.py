"""Tasks that workers of a test run; found there because the workers share the test's sys.path."""

import os
import time
from pathlib import Path


class Counter:
    """A tool that tells how often it was built and used in its process."""

    def __init__(self) -> None:
        self.num_uses = 0


def square(_tool: object, value: int) -> int:
    return value * value


def uses_of_tool(tool: Counter, seconds: float) -> tuple[int, int]:
    tool.num_uses += 1
    time.sleep(seconds)
    return os.getpid(), tool.num_uses


def sleep(_tool: object, seconds: float) -> float:
    time.sleep(seconds)
    return seconds


def mark_and_sleep(_tool: object, task: tuple[str, float]) -> None:
    path, seconds = task
    Path(path).touch()
    time.sleep(seconds)


def fail(_tool: object, value: int) -> int:
    raise ValueError(f"{value} is odd\nand this is a second line")


def die(_tool: object, _task: int) -> None:
    os.abort()


def die_once(_tool: object, marker: str) -> str:
    path = Path(marker)
    if not path.exists():
        path.touch()
        os.abort()
    return "survived"


def big(_tool: object, blob: bytes) -> bytes:
    return blob[::-1]


def niceness(_tool: object, _task: int) -> int:
    return os.nice(0)


def unsendable(_tool: object, _task: int) -> object:
    return (i for i in range(3))
