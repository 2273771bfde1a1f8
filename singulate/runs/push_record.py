"""One push of a run, with all that is needed to see it again."""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass

from singulate.exceptions import InvalidValueError
from singulate.geometry import BlockPose, Poses, Push
from singulate.outcomes import OUTCOMES


@dataclass(frozen=True)
class PushRecord:
    """A push as it was executed.

    Attributes:
        step: Training step.
        episode: Episode of the run.
        push: What was executed.
        reward: Total reward.
        terms: Unweighted reward terms by name.
        is_success: Whether the scene was singulated afterwards.
        outcome: One of `OUTCOMES`.
        poses: The scene at rest before; physics from there gives the same push again.
        predicted: Reward that the agent expected, None where it cannot tell.
        push_id: Number in the record, from 1 on; None until it is recorded.

    Raises:
        InvalidValueError: If the outcome is unknown or the reward is not finite.
    """

    step: int
    episode: int
    push: Push
    reward: float
    terms: Mapping[str, float]
    is_success: bool
    outcome: str
    poses: Poses
    predicted: float | None = None
    push_id: int | None = None

    def __post_init__(self) -> None:
        if self.outcome not in OUTCOMES:
            raise InvalidValueError("outcome", self.outcome, ", ".join(OUTCOMES))
        if not math.isfinite(self.reward):
            raise InvalidValueError("reward", self.reward, "a finite number")


def poses_to_json(poses: Poses) -> str:
    """Poses as compact text that reads back bit for bit."""
    plain = [
        [[float(v) for v in pose.position], [float(v) for v in pose.quaternion], float(pose.side)]
        for pose in poses
    ]
    return json.dumps(plain, separators=(",", ":"), allow_nan=False)


def poses_from_json(text: str) -> Poses:
    """The inverse of `poses_to_json`.

    Raises:
        ValueError: If the text is not such a list.
    """
    try:
        return tuple(
            BlockPose(_triple(p), _quadruple(q), float(side)) for p, q, side in json.loads(text)
        )
    except TypeError as error:
        raise ValueError(f"not poses: {error}") from error


def _triple(values: list[float]) -> tuple[float, float, float]:
    x, y, z = values
    return float(x), float(y), float(z)


def _quadruple(values: list[float]) -> tuple[float, float, float, float]:
    x, y, z, w = values
    return float(x), float(y), float(z), float(w)
