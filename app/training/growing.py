"""Arrays that grow at the end without being copied each time."""

from typing import Generic, TypeVar

import numpy as np
import numpy.typing as npt

ScalarT = TypeVar("ScalarT", bound=np.generic)


class GrowingArray(Generic[ScalarT]):
    """Rows of equal shape; views that were handed out keep their content.

    Args:
        dtype: Type of the values.
        row_shape: Shape of one row; a single value by default.
    """

    def __init__(self, dtype: type[ScalarT], row_shape: tuple[int, ...] = ()) -> None:
        self._rows: npt.NDArray[ScalarT] = np.empty((64, *row_shape), dtype)
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def extend(self, rows: npt.NDArray[ScalarT]) -> None:
        """Append rows, shape (N, *row_shape)."""
        needed = self._count + len(rows)
        if needed > len(self._rows):
            larger = np.empty(
                (max(needed, 2 * len(self._rows)), *self._rows.shape[1:]), self._rows.dtype
            )
            larger[: self._count] = self._rows[: self._count]
            self._rows = larger
        self._rows[self._count : needed] = rows
        self._count = needed

    @property
    def view(self) -> npt.NDArray[ScalarT]:
        """All rows so far, read-only, not copied."""
        view = self._rows[: self._count]
        view.flags.writeable = False
        return view
