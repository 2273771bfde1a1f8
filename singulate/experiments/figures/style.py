"""One quiet style for all figures, readable in print and with any colour vision.

Colours of lines are those of Okabe and Ito; maps follow viridis, even in lightness.
"""

import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from singulate.checkpoints.durable import replace_file
from singulate.geometry import Poses, Workspace

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, FigureBase

BLUE, ORANGE, GREEN, PINK, GREY = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#666666"
MAP_COLOURS = "viridis"
WIDTH_INCHES = 7.0
DOTS_PER_INCH = 200
SMALL, NORMAL = 8, 9
_LINES = {
    BLUE: "-",
    ORANGE: (0, (5, 1.5)),
    GREEN: (0, (1.5, 1.2)),
    PINK: (0, (5, 1.2, 1.2, 1.2)),
    GREY: (0, (5, 1.2, 1.2, 1.2, 1.2, 1.2)),
}
"""Lines also differ in their dashes, for prints without colour."""


def new_figure(
    num_rows: int, num_cols: int, height: float, **options: Any
) -> tuple["Figure", list["Axes"]]:
    """An empty figure and its panels, row after row; `height` in inches."""
    figure = empty_figure(height)
    panels = figure.subplots(num_rows, num_cols, squeeze=False, **options)
    return figure, list(panels.ravel())


def empty_figure(height: float) -> "Figure":
    """A figure without panels; `height` in inches."""
    from matplotlib.figure import Figure

    return Figure(figsize=(WIDTH_INCHES, height), layout="constrained", facecolor="white")


def save_figure(figure: "Figure", path: Path) -> None:
    """Write a picture as a whole or not at all.

    Raises:
        OSError: If it cannot be written.
    """
    image = io.BytesIO()
    figure.savefig(image, format="png", dpi=DOTS_PER_INCH, metadata={"Software": None})
    replace_file(path, image.getvalue())


def quiet_axes(panel: "Axes", title: str = "") -> None:
    """Axes for curves: two spines, a light grid."""
    panel.set_title(title, fontsize=NORMAL, loc="left")
    panel.tick_params(labelsize=SMALL)
    panel.spines[["top", "right"]].set_visible(False)
    panel.grid(axis="y", color="0.9", linewidth=0.8)
    panel.set_axisbelow(True)


def draw_band(panel: "Axes", steps: Any, values: Any, colour: str, label: str) -> None:
    """Median over seeds as a line, and their range as a band.

    Args:
        panel: Where.
        steps: Pushes, (N,).
        values: (num_seeds, N).
        colour: One of this module's.
        label: For the legend.
    """
    thousands = np.asarray(steps) / 1000.0
    median = np.median(values, axis=0)
    panel.plot(thousands, median, color=colour, linestyle=_LINES[colour], lw=1.6, label=label)
    panel.fill_between(
        thousands, values.min(axis=0), values.max(axis=0), color=colour, alpha=0.18, lw=0
    )


def note_seeds(figure: "FigureBase", text: str, num_seeds: int, more: str = "") -> None:
    """Say below a figure of curves what they are of, and of how many seeds."""
    seeds = f"median and range over {num_seeds} seeds" if num_seeds > 1 else "one seed"
    figure.supxlabel(f"{text}, {seeds}{more}", fontsize=SMALL, color="0.35")


def quiet_map(panel: "Axes", title: str = "") -> None:
    """Axes for pictures of the table: no ticks."""
    panel.set_title(title, fontsize=NORMAL)
    panel.set_xticks([])
    panel.set_yticks([])
    panel.spines[:].set_color("0.7")


def draw_map(panel: "Axes", values: Any, limits: tuple[float, float], **options: Any) -> Any:
    """A map of the table in metres; row 0 is +y."""
    half = Workspace().half_length
    return panel.imshow(
        np.asanyarray(values),
        extent=(-half, half, -half, half),
        vmin=limits[0],
        vmax=limits[1],
        interpolation="nearest",
        **{"cmap": MAP_COLOURS, **options},
    )


def draw_blocks(panel: "Axes", corners: Sequence[Any], colour: str = "white") -> None:
    """Outlines of blocks, each (K, 2) [m]."""
    for outline in corners:
        closed = np.vstack([outline, outline[:1]])
        panel.plot(closed[:, 0], closed[:, 1], color=colour, lw=1.2)


def outlines(poses: Poses) -> list[list[list[float]]]:
    """Outlines of blocks for JSON, [m]."""
    from singulate.simulation.footprint import block_footprint

    return [block_footprint(pose).round(5).tolist() for pose in poses]


def colour_bar(figure: "Figure", image: Any, panels: Sequence["Axes"], label: str) -> None:
    """A thin scale beside some panels."""
    bar = figure.colorbar(image, ax=list(panels), shrink=0.85, pad=0.015, aspect=25)
    bar.set_label(label, fontsize=SMALL)
    bar.ax.tick_params(labelsize=SMALL)
    bar.outline.set_visible(False)
