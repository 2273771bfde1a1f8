"""Soft contact shadows: one picture on the table, visible on draped fields too."""

import cv2
import numpy as np
import numpy.typing as npt
import viser

from singulate.geometry import BlockPose, Poses, Workspace
from singulate.geometry.rectangle import rectangle

_PIXELS = 160
_DARKNESS = 0.55
_BLUR_M = 0.022
_OFFSET_M = (0.008, -0.008)
"""The light comes from the left and the back, so shadows lie a little to the front right."""
_HEIGHT = 0.003
_SUBPIXEL_BITS = 4


class ShadowsView:
    """The shadows of all blocks.

    One picture for all of them, because separate transparent pictures hide each other and the
    field below, depending on the order in which the browser draws them.

    Args:
        scene: Where they are drawn.
        workspace: Decides the size of the picture.
    """

    def __init__(self, scene: viser.SceneApi, workspace: Workspace) -> None:
        self._reach = workspace.half_length + 0.1
        self._image = scene.add_image(
            "/shadows",
            np.zeros((_PIXELS, _PIXELS, 4), dtype=np.uint8),
            2 * self._reach,
            2 * self._reach,
            format="png",
            cast_shadow=False,
            position=(0.0, 0.0, _HEIGHT),
        )

    def update(self, poses: Poses) -> None:
        """Draw the shadows of these blocks."""
        self._image.image = shadows(poses, self._reach)


def shadows(poses: Poses, reach: float) -> npt.NDArray[np.uint8]:
    """Picture of the shadows under blocks.

    Args:
        poses: The blocks.
        reach: Half the side of the picture [m].

    Returns:
        RGBA uint8 (H, W, 4), black and more or less transparent; row 0 at -y, as viser wants it.
    """
    scale = _PIXELS / (2 * reach)
    alpha = np.zeros((_PIXELS, _PIXELS), dtype=np.uint8)
    for pose in poses:
        corners = _footprint(pose) + np.array(_OFFSET_M)
        pixels = (corners + reach) * scale - 0.5
        fixed_point = np.round(pixels * (1 << _SUBPIXEL_BITS)).astype(np.int32)
        cv2.fillConvexPoly(alpha, fixed_point, 255, cv2.LINE_AA, _SUBPIXEL_BITS)
    picture = np.zeros((_PIXELS, _PIXELS, 4), dtype=np.uint8)
    picture[..., 3] = cv2.GaussianBlur(alpha, (0, 0), _BLUR_M * scale) * _DARKNESS
    return picture


def _footprint(pose: BlockPose) -> npt.NDArray[np.float64]:
    return rectangle(pose.position[:2], (pose.side / 2, pose.side / 2), pose.yaw)
