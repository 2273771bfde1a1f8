"""Pieces of HTML that all panels use, so that they look made by one hand.

Colours come from the page's own variables and so follow light and dark. Texts from outside go
through `escape`.
"""

from collections.abc import Sequence
from html import escape

import viser

from app.fields.field_image import Rgba
from app.fields.inline_image import data_uri

__all__ = ["block", "dimmed", "escape", "picture", "ring", "show", "table", "title"]

BORDER = "var(--mantine-color-default-border)"
DIM = "var(--mantine-color-dimmed)"
LONGEST_NOTE = 30
"""Characters of a note that fit beside a heading; longer ones go below it."""


def block(*parts: str) -> str:
    """Frame of every piece of text in a panel: same margins, same size."""
    return (
        '<div style="padding:0 10px 8px 10px;font-size:13px;line-height:18px;'
        f'overflow-wrap:anywhere">{"".join(parts)}</div>'
    )


def title(text: str, note: str = "") -> str:
    """A quiet heading inside a panel, with a dimmed note at its right; both are escaped."""
    if len(note) > LONGEST_NOTE:
        return title(text) + dimmed(note)
    return (
        '<div style="display:flex;justify-content:space-between;align-items:baseline;gap:8px;'
        f'padding:2px 0 4px 0"><span style="font-weight:500">{escape(text)}</span>'
        f'<span style="color:{DIM};font-size:12px;text-align:right">{escape(note)}</span></div>'
    )


def dimmed(text: str) -> str:
    """A line of secondary text; `text` is escaped."""
    return f'<div style="color:{DIM};font-size:12px;line-height:17px">{escape(text)}</div>'


def picture(image: Rgba, alt: str, overlay: str = "") -> str:
    """A square picture of the table, as wide as its column.

    Args:
        image: uint8 (H, W, 3 or 4).
        alt: What it shows; escaped.
        overlay: HTML placed over it.
    """
    return (
        f'<div style="position:relative;line-height:0;border:1px solid {BORDER};'
        'border-radius:3px;overflow:hidden;background:rgba(128,128,128,0.10)">'
        f'<img alt="{escape(alt, quote=True)}" decoding="sync" src="{data_uri(image)}" '
        'style="width:100%;aspect-ratio:1;image-rendering:pixelated;display:block">'
        f"{overlay}</div>"
    )


def ring(cell: tuple[int, int], resolution: int) -> str:
    """A small ring over one cell (row, column) of a picture, visible on any colour.

    Args:
        cell: The cell.
        resolution: Cells along each side of the picture.
    """
    top, left = (100.0 * (index + 0.5) / resolution for index in cell)
    return (
        f'<div style="position:absolute;top:{top:.1f}%;left:{left:.1f}%;width:10px;height:10px;'
        "margin:-5px 0 0 -5px;border-radius:50%;border:1.5px solid #ffffff;"
        'box-shadow:0 0 0 1px #000000,inset 0 0 0 1px #000000;box-sizing:border-box"></div>'
    )


def table(rows: Sequence[Sequence[str]], head: Sequence[str] = ()) -> str:
    """A table whose first column is text and whose others are numbers; cells are HTML."""
    text_cell = "padding:1px 0;text-align:left;font-weight:400"
    number_cell = (
        "padding:1px 0 1px 8px;text-align:right;font-weight:400;white-space:nowrap;"
        "font-variant-numeric:tabular-nums"
    )

    def line(cells: Sequence[str], tag: str, colour: str) -> str:
        styles = (text_cell, *[number_cell] * (len(cells) - 1))
        return "".join(
            f'<{tag} style="{style};color:{colour}">{text}</{tag}>'
            for style, text in zip(styles, cells, strict=True)
        )

    lines = [line(head, "th", DIM)] if head else []
    lines += [line(row, "td", "inherit") for row in rows]
    body = "".join(f"<tr>{cells}</tr>" for cells in lines)
    return f'<table style="width:100%;border-collapse:collapse">{body}</table>'


def show(handle: viser.GuiHtmlHandle, content: str) -> None:
    """Put text on the page if it differs from what is there."""
    if handle.content != content:
        handle.content = content
