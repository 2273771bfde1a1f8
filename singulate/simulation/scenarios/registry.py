"""Scenarios by name; a new family is one entry here."""

import re
from typing import NamedTuple

from singulate.exceptions import InvalidValueError
from singulate.simulation.scenarios.cluster import random_cluster
from singulate.simulation.scenarios.row import fixed_row, random_row
from singulate.simulation.scenarios.scenario import Sampler, Scenario

_MAX_ROW_FOR_ONE_PUSH = 3
"""One push can take rows of two and three apart (paper, Fig. 1 and section 5.4)."""


class ScenarioFamily(NamedTuple):
    """Scenes of one kind, with the numbers of blocks that it allows."""

    sampler: Sampler
    min_blocks: int
    max_blocks: int
    is_row: bool


SCENARIO_FAMILIES = {
    "fixed": ScenarioFamily(fixed_row, 2, 3, is_row=True),
    "random": ScenarioFamily(random_row, 2, 8, is_row=True),
    "cluster": ScenarioFamily(random_cluster, 3, 10, is_row=False),
}


def scenario_names() -> tuple[str, ...]:
    """Every name that `make_scenario` accepts."""
    return tuple(
        f"{name}-{count}"
        for name, family in SCENARIO_FAMILIES.items()
        for count in range(family.min_blocks, family.max_blocks + 1)
    )


def make_scenario(name: str) -> Scenario:
    """Look a scenario up.

    Args:
        name: Such as ``random-2``.

    Raises:
        InvalidValueError: If there is no such scenario.
    """
    match = re.fullmatch(r"([a-z]+)-([0-9]{1,2})", name) if isinstance(name, str) else None
    family = SCENARIO_FAMILIES.get(match[1]) if match else None
    if match is None or family is None or name not in scenario_names():
        allowed = ", ".join(
            f"{key}-{f.min_blocks}..{f.max_blocks}" for key, f in SCENARIO_FAMILIES.items()
        )
        raise InvalidValueError("scenario", name, allowed)
    count = int(match[2])
    one_push = family.is_row and count <= _MAX_ROW_FOR_ONE_PUSH
    return Scenario(name, count, 1 if one_push else count, family.sampler)
