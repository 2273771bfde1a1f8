"""Engines under test: one fixture, so that every engine passes the same conformance tests."""

import gc
import sys
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from singulate.engine import Engine, LocalEngine, open_engine
from singulate.engine.ray_connection import connect, disconnect

sys.path.append(str(Path(__file__).parent))

ENGINES: dict[str, Callable[[], Engine]] = {
    "local": lambda: LocalEngine(num_workers=2),
    "ray": lambda: open_engine("ray", num_workers=2),
}


@pytest.fixture(scope="session")
def local_ray() -> Iterator[None]:
    """One Ray for all tests: its start takes seconds."""
    has_connected = connect(None, num_cpus=4)
    yield
    if has_connected:
        disconnect()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResourceWarning)  # Ray does not wait for its processes
        gc.collect()


@pytest.fixture(params=sorted(ENGINES))
def engine(request: pytest.FixtureRequest) -> Iterator[Engine]:
    if request.param == "ray":
        request.getfixturevalue("local_ray")
    with ENGINES[request.param]() as engine:
        yield engine
