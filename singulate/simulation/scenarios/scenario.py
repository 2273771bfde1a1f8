"""What every scenario provides."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from singulate.geometry import Layout, Workspace

SIDE_RANGE = (0.15, 0.25)
"""Sides of blocks that vary [m]."""
FIXED_SIDE = 0.2
"""Side of the blocks in fixed scenes [m]."""


class Sampler(Protocol):
    """Draws the blocks of one scene."""

    def __call__(self, num_blocks: int, rng: np.random.Generator, workspace: Workspace) -> Layout:
        """Draw `num_blocks` blocks inside the workspace."""
        ...


@dataclass(frozen=True)
class Scenario:
    """A family of scenes with a number of blocks.

    Attributes:
        name: As users write it, such as ``random-2``.
        num_blocks: Blocks in every scene; in a mix, in the largest.
        default_max_pushes: Pushes an episode may take unless the user says otherwise.
    """

    name: str
    num_blocks: int
    default_max_pushes: int
    sampler: Sampler

    def sample(self, rng: np.random.Generator, workspace: Workspace) -> Layout:
        """Draw the blocks of one scene; the generator alone decides."""
        return self.sampler(self.num_blocks, rng, workspace)
