"""Scenarios by name; a new family is one entry here."""

import re
from typing import NamedTuple

from singulate.exceptions import InvalidValueError
from singulate.simulation.scenarios.cluster import random_cluster
from singulate.simulation.scenarios.mix import SEPARATOR, mix
from singulate.simulation.scenarios.row import fixed_row, random_row
from singulate.simulation.scenarios.scenario import Sampler, Scenario

_MAX_ROW_FOR_ONE_PUSH = 3
"""One push can take rows of two and three apart (paper, Fig. 1 and section 5.4)."""

_MAX_PARTS = 8


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
    """Every name that `make_scenario` accepts, but for mixes."""
    return tuple(
        f"{name}-{count}"
        for name, family in SCENARIO_FAMILIES.items()
        for count in range(family.min_blocks, family.max_blocks + 1)
    )


def make_scenario(name: str) -> Scenario:
    """Look a scenario up.

    Args:
        name: Such as ``random-2``, or several for a mix, such as ``random-2+random-3``.

    Raises:
        InvalidValueError: If there is no such scenario.
    """
    parts = name.split(SEPARATOR) if isinstance(name, str) else [name]
    if len(parts) > _MAX_PARTS:
        raise InvalidValueError("scenario", name, f"a mix of at most {_MAX_PARTS} scenarios")
    scenarios = [_single(part) for part in parts]
    return scenarios[0] if len(scenarios) == 1 else mix(scenarios)


def _single(name: object) -> Scenario:
    match = re.fullmatch(r"([a-z]+)-([0-9]{1,2})", name) if isinstance(name, str) else None
    family = SCENARIO_FAMILIES.get(match[1]) if match else None
    if match is None or family is None or match[0] not in scenario_names():
        allowed = ", ".join(
            f"{key}-{f.min_blocks}..{f.max_blocks}" for key, f in SCENARIO_FAMILIES.items()
        )
        raise InvalidValueError("scenario", name, f"{allowed}, or a mix, such as random-2+random-3")
    count = int(match[2])
    one_push = family.is_row and count <= _MAX_ROW_FOR_ONE_PUSH
    return Scenario(match[0], count, 1 if one_push else count, family.sampler)
