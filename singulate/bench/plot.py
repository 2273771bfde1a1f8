"""Curves of the cost as work grows."""

from pathlib import Path
from typing import TYPE_CHECKING

from singulate.bench.measurement import Measurement
from singulate.bench.results import BenchResults
from singulate.exceptions import InvalidValueError, SingulateError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FORMATS = (".png", ".svg")
_NUM_COLUMNS = 3
_LABELS = {
    "blocks": "blocks in the row",
    "pixels": "starts along each side of the map",
    "workers": "worker processes",
    "clients": "browsers at the page",
}
_COLOUR = "#1f5fa8"


def check_plot_target(path: Path) -> None:
    """Check that a plot can be drawn and what it is to be.

    Raises:
        InvalidValueError: If the file's name does not end like a picture's.
        SingulateError: If Matplotlib is not installed.
    """
    if path.suffix not in FORMATS:
        raise InvalidValueError("plot", str(path), f"a file that ends in {' or '.join(FORMATS)}")
    try:
        import matplotlib.figure  # noqa: F401
    except ImportError:
        raise SingulateError(
            "a plot needs Matplotlib: pip install -c constraints.txt -e '.[bench]'"
        ) from None


def save_plot(results: BenchResults, path: Path) -> None:
    """Draw each curve in a panel of its own, from zero.

    Raises:
        InvalidValueError: If there is no curve among the results.
    """
    from matplotlib.figure import Figure

    curves = results.curves
    if not curves:
        raise InvalidValueError("plot", str(path), "results with curves, such as those of growth")
    num_rows = -(-len(curves) // _NUM_COLUMNS)
    figure = Figure(figsize=(9.0, 2.5 * num_rows + 0.3), layout="constrained", facecolor="white")
    panels = figure.subplots(num_rows, _NUM_COLUMNS, squeeze=False).ravel()
    for panel, ((axis, name), points) in zip(panels, curves.items(), strict=False):
        _draw(panel, axis, name, points)
    for panel in panels[len(curves) :]:
        panel.set_axis_off()
    figure.savefig(path, dpi=110)


def _draw(panel: "Axes", axis: str, name: str, points: list[Measurement]) -> None:
    at = [point.at or 0.0 for point in points]
    values = [point.value or 0.0 for point in points]
    panel.plot(at, values, "o-", color=_COLOUR, markersize=5)
    panel.set_title(name, fontsize=10, loc="left")
    panel.set_xlabel(_LABELS.get(axis, axis), fontsize=9)
    panel.set_ylabel(points[0].unit, fontsize=9)
    panel.set_xticks(at, [f"{each:g}" for each in at], fontsize=9)
    panel.tick_params(axis="y", labelsize=9)
    panel.set_ylim(0.0, 1.12 * max(values) or 1.0)
    panel.margins(x=0.08)
    panel.grid(axis="y", color="#dddddd", linewidth=0.8)
    panel.set_axisbelow(True)
    panel.spines[["top", "right"]].set_visible(False)
