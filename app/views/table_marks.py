"""The table top as one picture: border, grid, axes and numerals of the workspace."""

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw, ImageFont

from app.views.palette import Colour, Surface
from singulate.geometry import Workspace

PIXELS = 1400
_BORDER_M = 0.007
_FONT_HEIGHT_M = 0.056
_NUM_CELLS = 4


def table_marks(workspace: Workspace, margin: float, colours: Surface) -> npt.NDArray[np.uint8]:
    """Draw what is printed on the table.

    Args:
        workspace: The marked square.
        margin: How far the picture reaches beyond it on each side [m]; numerals stand there.
        colours: Of the page's theme.

    Returns:
        RGB uint8 (PIXELS, PIXELS, 3), row 0 at +y.
    """
    sheet = _Sheet(workspace, margin, colours.table)
    ticks = np.linspace(-workspace.half_length, workspace.half_length, _NUM_CELLS + 1)
    reach, outside = workspace.half_length, workspace.half_length + margin / 2
    for tick in ticks[1:-1]:
        sheet.line((tick, -reach), (tick, reach), colours.grid)
        sheet.line((-reach, tick), (reach, tick), colours.grid)
    sheet.frame(reach, colours.border)
    for tick in ticks:
        sheet.text(f"{tick:g}", (tick, -outside), colours.print)
        sheet.text(f"{tick:g}", (-outside, tick), colours.print)
    sheet.text("x [m]", ((ticks[-1] + ticks[-2]) / 2, -outside), colours.print)
    sheet.text("y [m]", (-outside, (ticks[-1] + ticks[-2]) / 2), colours.print)
    return sheet.pixels


class _Sheet:
    """A sheet in world coordinates."""

    def __init__(self, workspace: Workspace, margin: float, ground: Colour) -> None:
        self._reach = workspace.half_length + margin
        self._scale = PIXELS / (2 * self._reach)
        self._image = Image.new("RGB", (PIXELS, PIXELS), ground)
        self._draw = ImageDraw.Draw(self._image)
        self._font = ImageFont.load_default(_FONT_HEIGHT_M * self._scale)

    @property
    def pixels(self) -> npt.NDArray[np.uint8]:
        return np.asarray(self._image)

    def line(self, start: tuple[float, float], end: tuple[float, float], ink: Colour) -> None:
        self._draw.line([self._place(start), self._place(end)], fill=ink, width=2)

    def frame(self, reach: float, ink: Colour) -> None:
        """Around the square, so that nothing that is laid on the square hides it."""
        width = round(_BORDER_M * self._scale)
        left, top = self._place((-reach, reach))
        right, bottom = self._place((reach, -reach))
        box = (left - width, top - width, right + width, bottom + width)
        self._draw.rectangle(box, outline=ink, width=width)

    def text(self, text: str, centre: tuple[float, float], ink: Colour) -> None:
        self._draw.text(self._place(centre), text, fill=ink, font=self._font, anchor="mm")

    def _place(self, xy: tuple[float, float]) -> tuple[float, float]:
        return (xy[0] + self._reach) * self._scale, (self._reach - xy[1]) * self._scale
