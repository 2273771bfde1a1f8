"""The part of the camera's image in which something can be seen."""

from typing import NamedTuple

from singulate.geometry import Poses, Workspace
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import CUBE_REACH

_MARGIN_PX = 2
"""Room for the camera's perspective, which leans a block outward by less than a pixel."""


class PixelWindow(NamedTuple):
    """Rows ``top`` to ``bottom - 1`` and columns ``left`` to ``right - 1`` of an image."""

    top: int
    bottom: int
    left: int
    right: int

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width [px]."""
        return self.bottom - self.top, self.right - self.left


def full_window(workspace: Workspace) -> PixelWindow:
    """The whole image."""
    return PixelWindow(0, workspace.image_size, 0, workspace.image_size)


def window_of(poses: Poses, workspace: Workspace) -> PixelWindow | None:
    """A window that surely shows every block on the table; None without any."""
    standing = [pose for pose in poses if not is_fallen(pose)]
    if not standing:
        return None
    reach = CUBE_REACH * max(pose.side for pose in standing)
    xs = [pose.position[0] for pose in standing]
    ys = [pose.position[1] for pose in standing]
    top, left = workspace.xy_to_row_col(min(xs) - reach, max(ys) + reach)
    bottom, right = workspace.xy_to_row_col(max(xs) + reach, min(ys) - reach)
    size = workspace.image_size
    return PixelWindow(
        top=max(top - _MARGIN_PX, 0),
        bottom=min(bottom + 1 + _MARGIN_PX, size),
        left=max(left - _MARGIN_PX, 0),
        right=min(right + 1 + _MARGIN_PX, size),
    )
