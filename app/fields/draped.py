"""What one person has laid over the table."""

from dataclasses import dataclass

from app.fields.field_image import Rgba


@dataclass(frozen=True)
class DrapedField:
    """A field as it is to be drawn on the table.

    A new object is made only when something about it changed, so `is` tells whether to redraw.

    Attributes:
        rgba: uint8 (H, W, 4), row 0 at +y, cells already repeated for crisp edges.
        label: What it shows, for people.
        legend: Colour legend as HTML; empty for pictures.
    """

    rgba: Rgba
    label: str
    legend: str
