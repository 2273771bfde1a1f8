"""Variants of the same work take turns, so that a machine that slows down hurts nobody."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from singulate.engine import Engine

NUM_ROUNDS = 20
"""Turns of each variant."""


class Turn(NamedTuple):
    """What a worker is asked to do.

    Attributes:
        seconds: When to stop [s]; at least one step is made.
        seed: Draws scenes and pushes.
    """

    seconds: float
    seed: int


class Stint(NamedTuple):
    """What a worker did in its turn.

    Attributes:
        num_steps: Steps of its environment.
        seconds: Time that the environment took for them, resets included [s].
        total_seconds: The same with the drawing of pushes [s].
        simulated_seconds: What passed on the table [s].
    """

    num_steps: int
    seconds: float
    total_seconds: float
    simulated_seconds: float


@dataclass(frozen=True)
class Variant:
    """What takes turns with others.

    Attributes:
        engine: Where it works, with all workers at a time.
        work: Importable function from a tool and a `Turn` to a `Stint`.
        tool: Picklable factory of the tool.
    """

    engine: Engine
    work: Callable[[Any, Turn], Stint]
    tool: Callable[[], Any]


class Rate(NamedTuple):
    """What a variant does in a second.

    Attributes:
        steps: Steps of its environment a second.
        simulated: Seconds on the table a second.
    """

    steps: float
    simulated: float


def take_turns(variants: Mapping[str, Variant], seconds: float) -> dict[str, Rate]:
    """Let each variant work for a while, in short turns.

    Args:
        variants: By name. In the same round, all get the same seeds.
        seconds: Time for each variant in all [s].

    Raises:
        EngineError: If a variant fails.
    """
    for variant in variants.values():
        _turn(variant, 0.0, 0)  # builds the tools
    stints: dict[str, list[tuple[list[Stint], float]]] = {name: [] for name in variants}
    for number in range(NUM_ROUNDS):
        for name, variant in variants.items():
            began = time.perf_counter()
            found = _turn(variant, seconds / NUM_ROUNDS, number)
            stints[name].append((found, time.perf_counter() - began))
    return {name: _rate(each) for name, each in stints.items()}


def _turn(variant: Variant, seconds: float, number: int) -> list[Stint]:
    num_workers = variant.engine.num_workers
    turns = [Turn(seconds, number * num_workers + i) for i in range(num_workers)]
    return [result.value for result in variant.engine.submit(variant.work, turns, variant.tool)]


def _rate(turns: list[tuple[list[Stint], float]]) -> Rate:
    """Workers count as far as they worked at the same time."""
    stints = [stint for found, _ in turns for stint in found]
    at_a_time = sum(stint.total_seconds for stint in stints) / sum(wall for _, wall in turns)
    per_second = at_a_time / sum(stint.seconds for stint in stints)
    return Rate(
        sum(stint.num_steps for stint in stints) * per_second,
        sum(stint.simulated_seconds for stint in stints) * per_second,
    )
