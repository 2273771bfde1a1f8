"""Engines under test: one fixture, so that every engine passes the same conformance tests."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from singulate.engine import Engine, LocalEngine

sys.path.append(str(Path(__file__).parent))

ENGINES: dict[str, Callable[[], Engine]] = {"local": lambda: LocalEngine(num_workers=2)}


@pytest.fixture(params=sorted(ENGINES))
def engine(request: pytest.FixtureRequest) -> Iterator[Engine]:
    with ENGINES[request.param]() as engine:
        yield engine
