"""What the reward-map process and the laboratory tell each other (plain values only)."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from singulate.geometry import Poses


@dataclass(frozen=True)
class ComputeRewardMap:
    """Compute the reward of every push in a scene; replaces whatever is being computed."""

    version: int
    poses: Poses


@dataclass(frozen=True)
class CancelRewardMap:
    """Stop computing; what is there stays."""


@dataclass(frozen=True)
class RewardMapUpdate:
    """What has been computed so far; see `app.snapshot.RewardMapSnapshot`."""

    version: int
    values: npt.NDArray[np.float32]
    resolution: int
    progress: float


@dataclass(frozen=True)
class RewardMapProblem:
    """A reward map could not be computed: why, in one line."""

    version: int
    reason: str
