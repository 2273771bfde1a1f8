"""Scenes and pushes that the tests of this folder share."""

from collections.abc import Iterator

import pytest

from singulate.geometry import Block, Direction, Push
from singulate.simulation import Scene


@pytest.fixture
def scene() -> Iterator[Scene]:
    with Scene() as scene:
        yield scene


@pytest.fixture
def row() -> tuple[Block, ...]:
    return (Block(-0.2, 0.0), Block(0.0, 0.0), Block(0.2, 0.0))


@pytest.fixture
def middle_push() -> Push:
    return Push.cardinal((0.0, -0.3), Direction.UP, 0.5)
