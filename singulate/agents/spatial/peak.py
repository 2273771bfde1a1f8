"""The best start on a map of values: between the pixels, and with room for error."""

from typing import NamedTuple

import cv2
import numpy as np
import numpy.typing as npt

from singulate.agents.policy import FloatMap

SPREAD = 0.8
"""Standard deviation over which values are averaged before the best is chosen [px], 25 mm. A start
a pixel beside an equally good one that fails is worth less than one in the midst of good ones.
0, 0.7, 1 and 1.5 were compared on evaluation scenes of seed 12345: 0.7 and 1 did alike, 0 and 1.5
cost two successes in a hundred."""


class Peak(NamedTuple):
    """A maximum.

    Attributes:
        row: Its row, not a whole number.
        column: Its column, not a whole number.
        value: Averaged value of the pixel that it lies in.
    """

    row: float
    column: float
    value: float


def find_peak(values: FloatMap) -> Peak:
    """The highest point of a map, float32 (h, w), once values close by are averaged.

    The pixel's place is refined by the top of a parabola through it and its neighbours, along rows
    and along columns.
    """
    blurred = cv2.GaussianBlur(values, (0, 0), SPREAD, borderType=cv2.BORDER_REPLICATE)
    smooth = np.asarray(blurred, dtype=np.float32)
    row, column = np.unravel_index(int(smooth.argmax()), smooth.shape)
    down = _parabola_top(smooth[:, column], int(row))
    right = _parabola_top(smooth[row], int(column))
    return Peak(float(row) + down, float(column) + right, float(smooth[row, column]))


def _parabola_top(line: npt.NDArray[np.float32], index: int) -> float:
    """Offset of the top from a maximum of a line of values, within half a step."""
    if not 0 < index < len(line) - 1:
        return 0.0
    before, here, after = (float(value) for value in line[index - 1 : index + 2])
    bend = before - 2.0 * here + after
    return 0.0 if bend >= 0.0 else max(-0.5, min(0.5, (before - after) / (2.0 * bend)))
