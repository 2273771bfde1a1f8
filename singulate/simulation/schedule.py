"""Where the pusher is at each time step of a push."""

from dataclasses import dataclass
from functools import cached_property

from singulate.geometry import Push
from singulate.simulation.boxes import Vector3
from singulate.simulation.physics import Physics


@dataclass(frozen=True)
class PusherSchedule:
    """Along the push at constant speed, then straight up.

    Attributes:
        push: The push.
        physics: Speeds and the time step.
    """

    push: Push
    physics: Physics

    @cached_property
    def num_push_steps(self) -> int:
        """Time steps along the push."""
        return self.physics.num_push_steps(self.push.length)

    @property
    def num_steps(self) -> int:
        """Time steps in which the pusher moves."""
        return self.num_push_steps + self.physics.num_lift_steps

    def num_clear_steps(self, clear_length: float) -> int:
        """Whole steps of the push within a length of its beginning [m]."""
        if self.push.length == 0.0:
            return 0
        share = min(clear_length / self.push.length, 1.0)
        return int(share * self.num_push_steps)

    def position(self, step: int) -> Vector3:
        """Where the pusher's centre is after a step, (x, y, z) [m]."""
        (position,) = self.path(step - 1, step)
        return position

    def path(self, first: int, last: int) -> list[Vector3]:
        """Positions after the steps from `first`, which is left out, to `last`."""
        push, physics, num_push_steps = self.push, self.physics, self.num_push_steps
        (x, y), (dx, dy), z = push.start, push.direction, physics.pusher_z
        along = [
            push.length * step / num_push_steps
            for step in range(first + 1, min(last, num_push_steps) + 1)
        ]
        path = [(x + a * dx, y + a * dy, z) for a in along]
        rise = physics.retract_height / physics.num_lift_steps
        (x, y), first_lifted = push.end, max(first, num_push_steps) - num_push_steps
        for lifted in range(first_lifted + 1, last - num_push_steps + 1):
            path.append((x, y, z + rise * lifted))
        return path
