"""The table with the marks of the workspace."""

from functools import lru_cache

import numpy as np
import numpy.typing as npt
import viser

from app.views.palette import surface
from app.views.table_marks import table_marks
from singulate.geometry import Workspace

MARGIN = 0.14
"""How far the table reaches beyond the workspace [m]."""
_THICKNESS = 0.05


class TableView:
    """The table in one browser; its theme is that browser's.

    The top is one printed sheet and the edges are walls around nothing: a computer without a GPU
    pays for every layer that covers the picture, and for every kind of surface when a page opens
    (the walls are shaded like blocks).

    Args:
        scene: The browser's own scene.
        workspace: The square that is marked on the table.

    Attributes:
        top: The sheet; it can be dragged on.
    """

    def __init__(self, scene: viser.SceneApi, workspace: Workspace) -> None:
        self._workspace = workspace
        self._is_dark = False
        width = workspace.length + 2 * MARGIN
        colours = surface(False)
        self.top = scene.add_image(
            "/table/top",
            print_table(workspace, False),
            width,
            width,
            format="png",
            cast_shadow=False,
        )
        self._edges = scene.add_mesh_simple(
            "/table/edges",
            *_walls(width),
            color=colours.table,
            flat_shading=True,
            cast_shadow=False,
        )

    def update(self, is_dark: bool) -> None:
        """Follow the page's theme."""
        if is_dark == self._is_dark:
            return
        self._is_dark = is_dark
        self._edges.color = surface(is_dark).table
        self.top.image = print_table(self._workspace, is_dark)


@lru_cache(maxsize=4)
def print_table(workspace: Workspace, is_dark: bool) -> npt.NDArray[np.uint8]:
    """The picture on the table, the same for all pages; row 0 at -y, as viser wants it."""
    return np.ascontiguousarray(table_marks(workspace, MARGIN, surface(is_dark))[::-1])


def _walls(width: float) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.int32]]:
    """Vertices (8, 3) and triangles (8, 3) of the four edges, seen from outside."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=np.float32) * width / 2
    upper, lower = (np.insert(square, 2, z, axis=1) for z in (0.0, -_THICKNESS))
    here = np.arange(4)
    there = (here + 1) % 4
    faces = [(here, here + 4, there + 4), (here, there + 4, there)]
    return np.concatenate([upper, lower]), np.concatenate([np.stack(f, axis=1) for f in faces])
