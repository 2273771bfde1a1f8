"""What the policy process and the laboratory tell each other (plain values only)."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from singulate.geometry import Push
from singulate.perception.percept import Percept

FloatMap = npt.NDArray[np.float32]


@dataclass(frozen=True)
class Load:
    """Load a checkpoint directory."""

    source: str


@dataclass(frozen=True)
class Loaded:
    """A checkpoint has been loaded; it answers from now on."""

    source: str
    label: str
    kind: str
    num_steps: int
    has_q_map: bool


@dataclass(frozen=True)
class NotLoaded:
    """A checkpoint could not be loaded.

    Attributes:
        source: The checkpoint.
        reason: Why, in one line.
        has_other: Whether one that was loaded before it still answers.
    """

    source: str
    reason: str
    has_other: bool


@dataclass(frozen=True)
class ComputeFields:
    """Compute what the loaded policy believes about a scene; only what somebody looks at."""

    version: int
    percept: Percept
    wants_q_map: bool
    wants_start_density: bool


@dataclass(frozen=True)
class Fields:
    """What the policy believes about a scene, as far as it was asked and can tell.

    Attributes:
        source: The policy that was loaded when it answered.
        version: The scene's state at rest.
        q_map: float32 (4, H, W), or None.
        start_density: float32 (H, W) summing to 1, or None.
        start_modes: Cells (row, column) at which it has a mode, the most prominent first.
    """

    source: str
    version: int
    q_map: FloatMap | None
    start_density: FloatMap | None
    start_modes: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True)
class ChoosePush:
    """Choose the push to make in a scene."""

    version: int
    percept: Percept


@dataclass(frozen=True)
class ChosenPush:
    """The push that the policy would make."""

    version: int
    push: Push


@dataclass(frozen=True)
class PredictReward:
    """Predict what a push will bring."""

    push_id: int
    percept: Percept
    push: Push


@dataclass(frozen=True)
class Prediction:
    """The reward that the policy expects of a push; None where its kind cannot tell."""

    push_id: int
    reward: float | None


@dataclass(frozen=True)
class PolicyProblem:
    """A question could not be answered: why, in one line."""

    reason: str
