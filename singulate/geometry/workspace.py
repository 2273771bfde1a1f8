"""The reachable square of the table and how image cells map onto it."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True)
class Workspace:
    """A square centred at the origin; image row 0 is +y, column 0 is -x.

    Attributes:
        half_length: l of the paper [m].
        image_size: Pixels along each side of the camera image (paper, section 3.1).
    """

    half_length: float = 1.0
    image_size: int = 64

    @property
    def length(self) -> float:
        """Side of the square, 2l [m]."""
        return 2.0 * self.half_length

    @property
    def diagonal(self) -> float:
        """Longest distance inside the square [m]."""
        return math.sqrt(2.0) * self.length

    @property
    def push_length(self) -> float:
        """Length of the paper's push, one quarter of the workspace [m] (section 3.2.2)."""
        return self.length / 4.0

    @property
    def metres_per_pixel(self) -> float:
        """Side of one camera pixel on the table [m]."""
        return self.length / self.image_size

    def contains(self, x: float, y: float) -> bool:
        """Whether a point (x, y) [m] lies in the square, borders included."""
        return max(abs(x), abs(y)) <= self.half_length

    def xy_to_row_col(self, x: float, y: float, resolution: int | None = None) -> tuple[int, int]:
        """Cell that a point lies in; points outside fall into the nearest border cell.

        Args:
            x: World x [m].
            y: World y [m].
            resolution: Cells along each side; the image's own pixels by default.

        Returns:
            (row, col), each in [0, resolution).
        """
        cells = resolution or self.image_size
        size = self.length / cells
        row = math.floor((self.half_length - y) / size)
        col = math.floor((x + self.half_length) / size)
        return min(max(row, 0), cells - 1), min(max(col, 0), cells - 1)

    def row_col_to_xy(
        self, row: float, col: float, resolution: int | None = None
    ) -> tuple[float, float]:
        """World coordinates [m] of a cell's centre.

        Example:
            >>> Workspace().row_col_to_xy(0, 0, resolution=2)
            (-0.5, 0.5)
        """
        cells = resolution or self.image_size
        size = self.length / cells
        return (col + 0.5) * size - self.half_length, self.half_length - (row + 0.5) * size

    def cell_centres(self, resolution: int | None = None) -> npt.NDArray[np.float64]:
        """World coordinates [m] of all cell centres, shape (H, W, 2)."""
        return np.stack(np.meshgrid(*self.cell_axes(resolution)), axis=-1)

    def cell_axes(
        self, resolution: int | None = None
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """Places of the cells' columns along x, (W,), and of their rows along y, (H,) [m]."""
        cells = resolution or self.image_size
        along = (np.arange(cells, dtype=np.float64) + 0.5) * (self.length / cells)
        return along - self.half_length, self.half_length - along
