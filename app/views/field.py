"""The workspace: its print, and the field that one person has laid over it."""

from functools import lru_cache

import cv2
import numpy as np
import numpy.typing as npt
import viser

from app.fields.draped import DrapedField
from app.fields.resample import nearest
from app.views.palette import surface
from app.views.table_marks import WORKSPACE_PIXELS, workspace_marks
from singulate.geometry import Workspace

FIELD_NODE = "/field"


class FieldView:
    """The square of the workspace in one browser, one picture whatever lies on it.

    Args:
        scene: The browser's own scene.
        workspace: The square.

    Attributes:
        image: The picture; it can be dragged on.
    """

    def __init__(self, scene: viser.SceneApi, workspace: Workspace) -> None:
        self._workspace = workspace
        self._shown: tuple[DrapedField | None, bool] | None = None
        self.image = scene.add_image(
            FIELD_NODE,
            np.zeros((2, 2, 3), dtype=np.uint8),
            workspace.length,
            workspace.length,
            format="png",
            cast_shadow=False,
            receive_shadow=False,
        )

    def update(self, draped: DrapedField | None, is_dark: bool) -> None:
        """Lay a field over the workspace, or take it away, in the page's theme."""
        if self._shown is not None and self._shown[0] is draped and self._shown[1] == is_dark:
            return
        self._shown = (draped, is_dark)
        bare = print_workspace(self._workspace, is_dark)
        picture = bare if draped is None else laid_over(bare, draped.rgba)
        # viser puts row 0 of an image that lies in the plane at -y.
        self.image.image = np.ascontiguousarray(picture[::-1])


@lru_cache(maxsize=4)
def print_workspace(workspace: Workspace, is_dark: bool) -> npt.NDArray[np.uint8]:
    """The bare workspace, RGB uint8 (640, 640, 3), row 0 at +y; the same for all pages."""
    return workspace_marks(workspace, surface(is_dark))


def laid_over(ground: npt.NDArray[np.uint8], rgba: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """A field on the bare workspace.

    Args:
        ground: RGB uint8 (640, 640, 3).
        rgba: The field, uint8 (H, H, 4), 640 a multiple of H.

    Returns:
        RGB uint8 (640, 640, 3).
    """
    field = nearest(rgba, WORKSPACE_PIXELS).astype(np.uint8, copy=False)
    colours = cv2.cvtColor(field, cv2.COLOR_RGBA2RGB)
    alpha = cv2.merge([cv2.extractChannel(field, 3)] * 3)
    mixed = np.multiply(colours, alpha, dtype=np.uint16)
    mixed += np.multiply(ground, 255 - alpha, dtype=np.uint16)
    return np.asarray(cv2.convertScaleAbs(mixed, alpha=1 / 255), np.uint8)
