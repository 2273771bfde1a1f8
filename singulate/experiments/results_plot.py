"""Results of cells as a picture, readable in print."""

import io
import json
from collections.abc import Sequence
from pathlib import Path

from singulate.checkpoints.durable import replace_file
from singulate.experiments.results_table import Row, pooled

WIDTH_INCHES = 6.3
ROW_INCHES = 0.32
DOTS_PER_INCH = 200


def write_plot(path: Path, rows: Sequence[Row]) -> None:
    """Draw success rates: all seeds together with their interval, and each seed as a ring.

    Raises:
        OSError: If it cannot be written.
    """
    from matplotlib.figure import Figure

    groups = pooled(rows)
    figure = Figure(figsize=(WIDTH_INCHES, 0.9 + ROW_INCHES * len(groups)), layout="constrained")
    axes = figure.subplots()
    for y, group in enumerate(groups):
        rate = group["success_rate"]
        spread = [[rate - group["success_low"]], [group["success_high"] - rate]]
        axes.plot(
            group["rates"], [y] * len(group["rates"]), "o", mfc="none", mec="0.55", ms=5, zorder=1
        )
        axes.errorbar(rate, y, xerr=spread, fmt="o", color="black", ms=4, capsize=3, zorder=2)
    axes.set_yticks(range(len(groups)), [_label(group) for group in groups], fontsize=8)
    axes.set_ylim(len(groups) - 0.5, -0.5)
    axes.set_xlim(-0.02, 1.02)
    axes.set_xlabel("success on unseen scenes (95 % interval; rings: single seeds)", fontsize=9)
    axes.grid(axis="x", color="0.9")
    axes.set_axisbelow(True)
    image = io.BytesIO()
    figure.savefig(image, format="png", dpi=DOTS_PER_INCH)
    replace_file(path, image.getvalue())


def _label(group: Row) -> str:
    settings = [f"{key}={value}" for key, value in json.loads(group["settings"]).items()]
    return ", ".join([f"{group['agent']}, {group['scenario']}", *settings])
