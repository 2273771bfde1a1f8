"""Bullet, imported without the greeting that it prints on standard error."""

import os
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def _without_standard_error() -> Iterator[None]:
    kept = os.dup(2)
    try:
        with open(os.devnull, "w") as nowhere:
            os.dup2(nowhere.fileno(), 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)


with _without_standard_error():
    import pybullet

__all__ = ["pybullet"]
