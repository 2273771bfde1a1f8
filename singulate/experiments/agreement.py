"""How closely two ways of simulating the same pushes agree."""

from dataclasses import dataclass, field

import numpy as np

from singulate.geometry import Poses, Push

QUANTILES = (0.5, 0.9, 0.99)
YARDSTICK_M = 0.001
"""How much further back the plain push starts with which it is compared to itself [m]."""


@dataclass
class Agreement:
    """Differences to the plain push, collected push by push.

    Attributes:
        displacements: Largest distance of a block from where the plain push leaves it [m].
        reward_errors: Absolute difference of the reward.
        num_same_success: Pushes on whose success both agree.
    """

    displacements: list[float] = field(default_factory=list)
    reward_errors: list[float] = field(default_factory=list)
    num_same_success: int = 0

    def add(self, displacement: float, reward_error: float, is_same_success: bool) -> None:
        """Count one push."""
        self.displacements.append(displacement)
        self.reward_errors.append(reward_error)
        self.num_same_success += is_same_success

    def summary(self) -> dict[str, object]:
        """Plain numbers, for JSON; quantiles are those of `QUANTILES`."""
        num_pushes = len(self.reward_errors)
        return {
            "num_pushes": num_pushes,
            "success_agreement": self.num_same_success / max(1, num_pushes),
            "displacement_mm": _quantiles([1e3 * each for each in self.displacements]),
            "reward_error": _quantiles(self.reward_errors),
            "mean_reward_error": float(np.mean(self.reward_errors)) if num_pushes else 0.0,
        }


def displacement(one: Poses, other: Poses) -> float:
    """Largest distance between a block's two places [m]."""
    ends = [np.array([pose.position for pose in poses]) for poses in (one, other)]
    return float(np.linalg.norm(ends[0] - ends[1], axis=1).max())


def started_further_back(push: Push, distance: float = YARDSTICK_M) -> Push:
    """The same push with a longer approach: it ends where the push ends."""
    (x, y), (dx, dy) = push.start, push.direction
    start = (x - distance * dx, y - distance * dy)
    return Push(start, push.direction, push.length + distance)


def _quantiles(values: list[float]) -> dict[str, float]:
    if not values:
        return {}
    return {f"{q:g}": float(np.quantile(values, q)) for q in QUANTILES}
