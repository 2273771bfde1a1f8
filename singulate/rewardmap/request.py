"""What a reward map is asked for."""

import math
from dataclasses import dataclass

from singulate.exceptions import InvalidValueError
from singulate.geometry import Poses
from singulate.rewards import make_reward

MAX_RESOLUTION = 256


@dataclass(frozen=True)
class RewardMapRequest:
    """A scene at rest, and which pushes on it to value how.

    Attributes:
        poses: The blocks at rest.
        resolution: Starts along each side; a push starts at the centre of each cell.
        goal_separation: d_goal of Eq. 2 [m].
        reward: Name of the reward, such as ``paper``.
        num_pushes: Pushes that the run made before; decides rewards that follow a schedule.
        exact: Whether to execute every push, also those that are known to move nothing.

    Raises:
        InvalidValueError: If a value is not allowed.
    """

    poses: Poses
    resolution: int = 64
    goal_separation: float = 0.1
    reward: str = "paper"
    num_pushes: int = 0
    exact: bool = False

    def __post_init__(self) -> None:
        make_reward(self.reward)
        if not 1 <= self.resolution <= MAX_RESOLUTION:
            raise InvalidValueError("resolution", self.resolution, f"1 to {MAX_RESOLUTION}")
        if not 0.0 < self.goal_separation <= 1.0:
            raise InvalidValueError(
                "goal_separation", self.goal_separation, "more than 0, at most 1 [m]"
            )
        for i, pose in enumerate(self.poses):
            if not all(map(math.isfinite, (*pose.position, *pose.quaternion, pose.side))):
                raise InvalidValueError(f"poses[{i}]", pose, "finite numbers")
