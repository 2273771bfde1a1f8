"""Where the next push would start and which way it would go, for one person."""

from dataclasses import dataclass

from singulate.geometry import Direction, Push, Workspace

MIN_DRAG = 0.03
"""A drag shorter than this [m] is a slip of the hand, not an arrow."""


@dataclass(frozen=True)
class Aim:
    """An aimed push; every browser has its own.

    Attributes:
        start: Where the pusher would be lowered, (x, y) [m]; None before anything was pointed at.
        direction: The cardinal direction it would move in.
    """

    start: tuple[float, float] | None = None
    direction: Direction = Direction.UP

    def push(self, workspace: Workspace) -> Push | None:
        """The push that this aim stands for; None while nothing has been pointed at."""
        if self.start is None:
            return None
        return Push.cardinal(self.start, self.direction, workspace.push_length)


def aim_of_drag(
    start: tuple[float, float], end: tuple[float, float], workspace: Workspace
) -> Aim | None:
    """Aim of an arrow that was dragged over the table.

    Args:
        start: Where the button went down, (x, y) [m].
        end: Where the pointer is now, (x, y) [m].
        workspace: Only starts inside it count.

    Returns:
        The start with the cardinal direction nearest to the arrow's; None where the arrow is
        shorter than `MIN_DRAG` or starts off the table.
    """
    arrow = Push.between(start, end)
    if arrow.length < MIN_DRAG or not workspace.contains(*start):
        return None
    return Aim(start, arrow.nearest_direction)
