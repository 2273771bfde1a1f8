"""The four cardinal push directions, in the paper's order (Fig. 2)."""

from enum import IntEnum


class Direction(IntEnum):
    """A cardinal direction on the table; +y is up in every image, +x is right."""

    UP = 0
    RIGHT = 1
    DOWN = 2
    LEFT = 3

    @property
    def vector(self) -> tuple[float, float]:
        """Unit vector (x, y) in the world frame."""
        return _VECTORS[self]

    @property
    def label(self) -> str:
        """Lower-case name for people: ``up``, ``right``, ``down``, ``left``."""
        return self.name.lower()


_VECTORS = {
    Direction.UP: (0.0, 1.0),
    Direction.RIGHT: (1.0, 0.0),
    Direction.DOWN: (0.0, -1.0),
    Direction.LEFT: (-1.0, 0.0),
}
