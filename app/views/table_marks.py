"""What is printed on the table: numerals and border on its rim, a grid on the workspace."""

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw, ImageFont

from app.views.palette import Colour, Surface
from singulate.geometry import Workspace

RIM_SCALE = 600
"""Pixels a metre of the rim, whose numerals have to be sharp."""
WORKSPACE_PIXELS = 640
"""Pixels along each side of the workspace: a multiple of a draped field's."""
_BORDER_M = 0.007
_LINE_M = 0.003
_FONT_HEIGHT_M = 0.056
_NUM_CELLS = 4


def rim_marks(workspace: Workspace, margin: float, colours: Surface) -> npt.NDArray[np.uint8]:
    """Draw what is printed around the workspace.

    Args:
        workspace: The marked square.
        margin: How far the table reaches beyond it on each side [m].
        colours: Of the page's theme.

    Returns:
        RGB uint8 (P, P, 3) of the whole table, row 0 at +y, `RIM_SCALE` pixels a metre.
    """
    sheet = _Sheet(workspace.half_length + margin, RIM_SCALE, colours.table)
    ticks, outside = _ticks(workspace), workspace.half_length + margin / 2
    sheet.frame(workspace.half_length, colours.border)
    for tick in ticks:
        sheet.text(f"{tick:g}", (tick, -outside), colours.print)
        sheet.text(f"{tick:g}", (-outside, tick), colours.print)
    sheet.text("x [m]", ((ticks[-1] + ticks[-2]) / 2, -outside), colours.print)
    sheet.text("y [m]", (-outside, (ticks[-1] + ticks[-2]) / 2), colours.print)
    return sheet.pixels


def workspace_marks(workspace: Workspace, colours: Surface) -> npt.NDArray[np.uint8]:
    """Draw the grid of the workspace; RGB uint8 (640, 640, 3), row 0 at +y."""
    reach = workspace.half_length
    sheet = _Sheet(reach, WORKSPACE_PIXELS / workspace.length, colours.table)
    for tick in _ticks(workspace)[1:-1]:
        sheet.line((tick, -reach), (tick, reach), colours.grid)
        sheet.line((-reach, tick), (reach, tick), colours.grid)
    return sheet.pixels


def _ticks(workspace: Workspace) -> npt.NDArray[np.float64]:
    return np.linspace(-workspace.half_length, workspace.half_length, _NUM_CELLS + 1)


class _Sheet:
    """A sheet in world coordinates.

    Args:
        reach: Half its side [m].
        scale: Pixels a metre.
        ground: Its colour.
    """

    def __init__(self, reach: float, scale: float, ground: Colour) -> None:
        self._reach, self._scale = reach, scale
        pixels = round(2 * reach * scale)
        self._image = Image.new("RGB", (pixels, pixels), ground)
        self._draw = ImageDraw.Draw(self._image)
        self._font = ImageFont.load_default(_FONT_HEIGHT_M * self._scale)

    @property
    def pixels(self) -> npt.NDArray[np.uint8]:
        return np.asarray(self._image)

    def line(self, start: tuple[float, float], end: tuple[float, float], ink: Colour) -> None:
        width = max(1, round(_LINE_M * self._scale))
        self._draw.line([self._place(start), self._place(end)], fill=ink, width=width)

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
