"""The mesh of a flat arrow."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

_HEAD_LENGTH = 7.0
_HEAD_HALF_WIDTH = 3.2
_DEPTH = 0.3
"""In halves of the shaft's width."""

_NUM_CORNERS = 7


class ArrowShape(NamedTuple):
    """A plate in the shape of an arrow along +x, from its tail at the origin.

    Attributes:
        half_width: Half the width of its shaft [m].
    """

    half_width: float

    def vertices(self, length: float) -> npt.NDArray[np.float32]:
        """Its corners: the outline's at the height 0, then the same a little below.

        Args:
            length: From tail to tip [m]; one that is shorter than the usual head is all head.

        Returns:
            float32 (14, 3).
        """
        shaft = self.half_width
        neck = max(length - _HEAD_LENGTH * shaft, 0.0)
        head = _HEAD_HALF_WIDTH * shaft
        outline = np.array(
            [
                (0.0, -shaft), (neck, -shaft), (neck, -head), (length, 0.0),
                (neck, head), (neck, shaft), (0.0, shaft),
            ],
            dtype=np.float32,
        )  # fmt: skip
        below = -_DEPTH * shaft
        return np.concatenate([np.insert(outline, 2, z, axis=1) for z in (0.0, below)])

    def faces(self) -> npt.NDArray[np.int32]:
        """Triangles of the plate's top and walls, seen from outside; int32 (17, 3)."""
        top = [(0, 1, 5), (0, 5, 6), (2, 3, 4)]
        here = np.arange(_NUM_CORNERS)
        there = (here + 1) % _NUM_CORNERS
        below = here + _NUM_CORNERS
        walls = [(here, below, there), (there, below, there + _NUM_CORNERS)]
        return np.concatenate([top, *(np.stack(wall, axis=1) for wall in walls)]).astype(np.int32)
