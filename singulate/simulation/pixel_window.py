"""The part of the camera's image in which something can be seen."""

from typing import NamedTuple

from singulate.geometry import BlockPose, Poses, Workspace
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import CUBE_REACH

_PERSPECTIVE = 0.055
"""How far the camera sees the top of a block lean outward, as a share of its distance from the
middle of the table: at most that of two blocks of 0.5 m, one on the other."""
_UPRIGHT = 1e-6
"""A block whose quaternion has x and y of a smaller square does not lean."""


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
    xs, ys, _ = zip(*[pose.position for pose in standing], strict=True)
    reach = max([_reach(pose) for pose in standing]) + _PERSPECTIVE * workspace.half_length
    top, left = workspace.xy_to_row_col(min(xs) - reach, max(ys) + reach)
    bottom, right = workspace.xy_to_row_col(max(xs) + reach, min(ys) - reach)
    return PixelWindow(top, bottom + 1, left, right + 1)


def _reach(pose: BlockPose) -> float:
    """How far a block reaches along x and y from its centre, at most [m]."""
    x, y, z, w = pose.quaternion
    if x * x + y * y > _UPRIGHT:
        return CUBE_REACH * pose.side
    return (abs(w * w - z * z) + abs(2.0 * w * z)) * pose.side / 2.0
