"""The field that one person has laid over the table."""

import numpy as np
import viser

from app.fields.draped import DrapedField
from singulate.geometry import Workspace

_HEIGHT = 0.002


class FieldView:
    """An image just above the table, in one browser.

    Args:
        scene: The browser's own scene.
        workspace: The square that a field covers.
    """

    def __init__(self, scene: viser.SceneApi, workspace: Workspace) -> None:
        self._shown: DrapedField | None = None
        self._image = scene.add_image(
            "/field",
            np.zeros((2, 2, 4), dtype=np.uint8),
            workspace.length,
            workspace.length,
            format="png",
            cast_shadow=False,
            receive_shadow=0.25,
            position=(0.0, 0.0, _HEIGHT),
            visible=False,
        )

    def update(self, draped: DrapedField | None) -> None:
        """Lay a field over the table, or take it away."""
        if draped is self._shown:
            return
        self._shown = draped
        if draped is not None:
            # viser puts row 0 of an image that lies in the plane at -y.
            self._image.image = np.ascontiguousarray(draped.rgba[::-1])
        if self._image.visible != (draped is not None):
            self._image.visible = draped is not None
