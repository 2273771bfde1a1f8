"""Two colour maps that people with any colour vision can read, and a palette for segments.

The sequential one follows matplotlib's *viridis* (CC0), even in lightness from dark to bright; the
diverging one follows ColorBrewer's *RdBu*, from blue (below zero) over white to red (above).
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

TABLE_SIZE = 256


@dataclass(frozen=True)
class Colormap:
    """Colours along the unit interval.

    Attributes:
        name: Name for people.
        anchors: Hexadecimal colours (``#rrggbb``) at even distances.
        is_diverging: Whether the middle stands for zero.
    """

    name: str
    anchors: tuple[str, ...]
    is_diverging: bool = False

    @property
    def table(self) -> npt.NDArray[np.uint8]:
        """Interpolated colours, uint8 (256, 3)."""
        return _TABLES[self.name]

    @property
    def css_gradient(self) -> str:
        """The same colours, low to high, as a CSS background from left to right."""
        return f"linear-gradient(to right, {', '.join(self.anchors)})"


def hex_to_rgb(colour: str) -> tuple[int, int, int]:
    """Red, green and blue of ``#rrggbb``.

    Example:
        >>> hex_to_rgb("#ff8000")
        (255, 128, 0)
    """
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def _interpolate(colormap: Colormap) -> npt.NDArray[np.uint8]:
    anchors = np.array([hex_to_rgb(anchor) for anchor in colormap.anchors], dtype=np.float64)
    at = np.linspace(0.0, len(anchors) - 1.0, TABLE_SIZE)
    channels = [np.interp(at, np.arange(len(anchors)), anchors[:, i]) for i in range(3)]
    return np.stack(channels, axis=1).round().astype(np.uint8)


SEQUENTIAL = Colormap(
    "sequential",
    (
        "#440154", "#482878", "#3e4989", "#31688e", "#26828e",
        "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725",
    ),
)  # fmt: skip

DIVERGING = Colormap(
    "diverging",
    (
        "#053061", "#2166ac", "#4393c3", "#92c5de", "#d1e5f0", "#f7f7f7",
        "#fddbc7", "#f4a582", "#d6604d", "#b2182b", "#67001f",
    ),
    is_diverging=True,
)  # fmt: skip

SEGMENT_COLOURS = (
    "#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7", "#999999",
)  # fmt: skip
"""Okabe and Ito's palette; segments beyond it start again."""

_TABLES = {colormap.name: _interpolate(colormap) for colormap in (SEQUENTIAL, DIVERGING)}
