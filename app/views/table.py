"""The table around the workspace."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import viser

from app.views.palette import surface
from app.views.table_marks import RIM_SCALE, rim_marks
from singulate.geometry import Workspace

MARGIN = 0.14
"""How far the table reaches beyond the workspace [m]."""
_THICKNESS = 0.05


class RimView:
    """The table's rim in one browser; its theme is that browser's.

    A computer without a GPU pays for every layer that covers the picture, so nothing lies under
    the workspace, which `FieldView` draws. It also pays for every kind of surface when a page
    opens: the edges, walls around nothing, are shaded like blocks.

    Args:
        scene: The browser's own scene.
        workspace: The square that the rim goes around.
    """

    def __init__(self, scene: viser.SceneApi, workspace: Workspace) -> None:
        self._workspace = workspace
        self._is_dark = False
        self._strips = [
            scene.add_image(
                f"/table/rim/{index}",
                strip.picture,
                *strip.size,
                format="png",
                cast_shadow=False,
                position=(*strip.centre, 0.0),
            )
            for index, strip in enumerate(print_rim(workspace, False))
        ]
        self._edges = scene.add_mesh_simple(
            "/table/edges",
            *_walls(workspace.length + 2 * MARGIN),
            color=surface(False).table,
            flat_shading=True,
            cast_shadow=False,
        )

    def update(self, is_dark: bool) -> None:
        """Follow the page's theme."""
        if is_dark == self._is_dark:
            return
        self._is_dark = is_dark
        self._edges.color = surface(is_dark).table
        for shown, strip in zip(self._strips, print_rim(self._workspace, is_dark), strict=True):
            shown.image = strip.picture


class Strip(NamedTuple):
    """A rectangle of the printed rim.

    Attributes:
        picture: RGB uint8 (H, W, 3), row 0 at -y, as viser wants it.
        size: Along x and y [m].
        centre: (x, y) [m].
    """

    picture: npt.NDArray[np.uint8]
    size: tuple[float, float]
    centre: tuple[float, float]


@lru_cache(maxsize=4)
def print_rim(workspace: Workspace, is_dark: bool) -> tuple[Strip, ...]:
    """The rim in four strips, below, above, left and right; the same for all pages."""
    marks = rim_marks(workspace, MARGIN, surface(is_dark))[::-1]
    reach, inner = workspace.half_length + MARGIN, workspace.half_length
    rectangles = (
        (-reach, reach, -reach, -inner),
        (-reach, reach, inner, reach),
        (-reach, -inner, -inner, inner),
        (inner, reach, -inner, inner),
    )
    return tuple(_cut(marks, reach, *rectangle) for rectangle in rectangles)


def _cut(
    marks: npt.NDArray[np.uint8], reach: float, left: float, right: float, low: float, high: float
) -> Strip:
    columns, rows = (
        slice(*(round((edge + reach) * RIM_SCALE) for edge in edges))
        for edges in ((left, right), (low, high))
    )
    return Strip(
        np.ascontiguousarray(marks[rows, columns]),
        (right - left, high - low),
        ((left + right) / 2, (low + high) / 2),
    )


def _walls(width: float) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.int32]]:
    """Vertices (8, 3) and triangles (8, 3) of the four edges, seen from outside."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], dtype=np.float32) * width / 2
    upper, lower = (np.insert(square, 2, z, axis=1) for z in (0.0, -_THICKNESS))
    here = np.arange(4)
    there = (here + 1) % 4
    faces = [(here, here + 4, there + 4), (here, there + 4, there)]
    return np.concatenate([upper, lower]), np.concatenate([np.stack(f, axis=1) for f in faces])
