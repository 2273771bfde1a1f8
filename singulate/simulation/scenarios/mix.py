"""Mixes: every scene is one of several scenarios."""

from collections.abc import Sequence

import numpy as np

from singulate.geometry import Layout, Workspace
from singulate.simulation.scenarios.scenario import Scenario

SEPARATOR = "+"
"""Between the names of a mix, such as ``random-2+random-3``."""


def mix(parts: Sequence[Scenario]) -> Scenario:
    """Scenes of all the given scenarios, each scene of any of them with equal probability.

    The mix has as many blocks as its largest scenes, and allows as many pushes as any part needs.

    Args:
        parts: At least one scenario.
    """

    def sample(num_blocks: int, rng: np.random.Generator, workspace: Workspace) -> Layout:
        return parts[int(rng.integers(len(parts)))].sample(rng, workspace)

    return Scenario(
        SEPARATOR.join(part.name for part in parts),
        max(part.num_blocks for part in parts),
        max(part.default_max_pushes for part in parts),
        sample,
    )
