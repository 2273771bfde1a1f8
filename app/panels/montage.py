"""All four directions side by side, as in Figs. 2 and 5 of the paper."""

import numpy as np
import numpy.typing as npt

from app.fields.catalogue import FieldKind
from app.fields.field_image import Span, best_cell, field_image
from app.fields.legend import legend_html
from app.panels.markup import dimmed, picture, ring
from singulate.geometry import Direction

ARROWS = ("↑ up", "→ right", "↓ down", "← left")


def montage_html(
    kind: FieldKind, stack: npt.NDArray[np.float32], spans: tuple[Span, ...], has_legend: bool
) -> str:
    """Four small maps in the order up, right, down, left; a ring marks the best push of all.

    Args:
        kind: What they show.
        stack: float32 (4, H, W).
        spans: Colour range of each.
        has_legend: Whether one legend serves all four; otherwise each tells its own range.
    """
    bests = [best_cell(values) for values in stack]
    peaks = [
        float("-inf") if cell is None else float(values[cell])
        for values, cell in zip(stack, bests, strict=True)
    ]
    winner = int(np.argmax(peaks))
    figures = []
    for direction in Direction:
        cell = bests[direction] if direction == winner else None
        image = field_image(stack[direction], spans[direction], kind.colormap)
        mark = "" if cell is None else ring(cell, stack.shape[1])
        own = "" if has_legend else legend_html(spans[direction], kind.colormap)
        figures.append(
            '<div style="flex:1;min-width:0">'
            f"{picture(image, f'{kind.label} {direction.label}', mark)}"
            f"{dimmed(ARROWS[direction])}{own}</div>"
        )
    legend = legend_html(spans[0], kind.colormap, kind.unit) if has_legend else ""
    return f'<div style="display:flex;gap:4px">{"".join(figures)}</div>{legend}'
