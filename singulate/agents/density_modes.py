"""How many modes a density of start positions has."""

from typing import NamedTuple

import cv2
import numpy as np
import numpy.typing as npt

SMOOTHING_PX = 1.0
"""Standard deviation of the blur before counting [pixels]: half the pusher's width, about 3 cm."""

MIN_PROMINENCE = 0.1
"""Share of the highest peak that counts as a mode of its own."""


class Mode(NamedTuple):
    """A peak of a density.

    Attributes:
        row: Its pixel's row.
        col: Its pixel's column.
        height: The smoothed density there.
        prominence: How far one has to descend from it before reaching something higher; the
            height itself for the highest.
    """

    row: int
    col: int
    height: float
    prominence: float


def density_modes(
    density: npt.NDArray[np.float32],
    smoothing_px: float = SMOOTHING_PX,
    min_prominence: float = MIN_PROMINENCE,
) -> list[Mode]:
    """Peaks that stand out of a density.

    The density is blurred and flooded from the top: each peak raises an island, and where two
    islands meet, the lower one ends; its prominence is what it rose above the saddle (topological
    persistence; Edelsbrunner, Letscher and Zomorodian 2002). So ripples on a ridge do not count,
    however many, and a plateau counts once.

    Args:
        density: float32 (H, W), not negative.
        smoothing_px: Standard deviation of the blur [pixels]; 0 for none.
        min_prominence: Least prominence of a mode, as a share of the highest peak.

    Returns:
        Modes, the most prominent first; none where the density is 0 everywhere.
    """
    smooth = np.asarray(density, dtype=np.float64)
    if smoothing_px > 0.0:
        blurred = cv2.GaussianBlur(smooth, (0, 0), smoothing_px, borderType=cv2.BORDER_REFLECT)
        smooth = np.asarray(blurred, dtype=np.float64)
    highest = float(smooth.max())
    if highest <= 0.0:
        return []
    modes = [mode for mode in _peaks(smooth) if mode.prominence >= min_prominence * highest]
    return sorted(modes, key=lambda mode: mode.prominence, reverse=True)


def _peaks(heights: npt.NDArray[np.float64]) -> list[Mode]:
    """Every peak; pixels touch along sides and at corners."""
    num_rows, num_cols = heights.shape
    flat = heights.ravel()
    island = np.full(flat.size, -1)  # of each flooded pixel: one closer to its island's peak
    found = []
    for pixel in np.argsort(-flat, kind="stable"):
        row, col = divmod(int(pixel), num_cols)
        rows = range(max(row - 1, 0), min(row + 2, num_rows))
        cols = range(max(col - 1, 0), min(col + 2, num_cols))
        beside = {_peak_of(island, r * num_cols + c) for r in rows for c in cols} - {-1}
        ranked = sorted(beside, key=lambda peak: (-flat[peak], peak))
        winner = ranked[0] if ranked else int(pixel)
        island[pixel] = winner
        for loser in ranked[1:]:
            found.append(_mode(heights, loser, float(flat[loser] - flat[pixel])))
            island[loser] = winner
    last = _peak_of(island, int(flat.argmax()))
    return [*found, _mode(heights, last, float(flat[last]))]


def _peak_of(island: npt.NDArray[np.int_], pixel: int) -> int:
    if island[pixel] < 0:
        return -1
    while island[pixel] != pixel:
        island[pixel] = island[island[pixel]]
        pixel = int(island[pixel])
    return pixel


def _mode(heights: npt.NDArray[np.float64], pixel: int, prominence: float) -> Mode:
    row, col = divmod(pixel, heights.shape[1])
    return Mode(row, col, float(heights[row, col]), prominence)
