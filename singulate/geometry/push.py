"""A straight push in the world frame."""

import math
from dataclasses import dataclass
from typing import Self

from singulate.exceptions import InvalidValueError
from singulate.geometry.direction import Direction


@dataclass(frozen=True)
class Push:
    """One straight push.

    Attributes:
        start: Where the pusher is lowered, (x, y) [m].
        direction: Unit vector (x, y) along which it moves.
        length: How far it moves [m].

    Raises:
        InvalidValueError: If a value is not finite, the direction is not of unit length, or the
            length is negative.
    """

    start: tuple[float, float]
    direction: tuple[float, float]
    length: float

    def __post_init__(self) -> None:
        if not all(math.isfinite(value) for value in self.start):
            raise InvalidValueError("push.start", self.start, "two finite numbers [m]")
        if not abs(math.hypot(*self.direction) - 1.0) < 1e-6:
            raise InvalidValueError("push.direction", self.direction, "a unit vector")
        if not (math.isfinite(self.length) and self.length >= 0.0):
            raise InvalidValueError("push.length", self.length, "a finite number >= 0 [m]")

    @classmethod
    def cardinal(cls, start: tuple[float, float], direction: Direction, length: float) -> Self:
        """Push along one of the four cardinal directions."""
        return cls(start, direction.vector, length)

    @classmethod
    def between(cls, start: tuple[float, float], end: tuple[float, float]) -> Self:
        """Push from one point to another; coinciding points give a push of length 0."""
        dx, dy = end[0] - start[0], end[1] - start[1]
        length = math.hypot(dx, dy)
        if length == 0.0:
            return cls(start, Direction.UP.vector, 0.0)
        return cls(start, (dx / length, dy / length), length)

    @property
    def end(self) -> tuple[float, float]:
        """Where the pusher stops, (x, y) [m]."""
        return (
            self.start[0] + self.length * self.direction[0],
            self.start[1] + self.length * self.direction[1],
        )

    @property
    def yaw(self) -> float:
        """Angle of the direction from +x, counter-clockwise [rad]."""
        return math.atan2(self.direction[1], self.direction[0])

    @property
    def nearest_direction(self) -> Direction:
        """The cardinal direction closest to this push's."""
        x, y = self.direction
        return max(Direction, key=lambda d: d.vector[0] * x + d.vector[1] * y)
