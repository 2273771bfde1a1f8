"""The fixed RGB-D camera straight above the table."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from singulate.geometry import CameraFrame, Workspace
from singulate.simulation.bullet import pybullet
from singulate.simulation.pixel_window import PixelWindow, full_window

CAMERA_HEIGHT = 20.0
"""Height above the table [m]; from here a block of 0.2 m leans outward by at most 1 % of its
distance from the centre, a third of a pixel at the border."""

_NEAR = CAMERA_HEIGHT - 1.0
_FAR = CAMERA_HEIGHT + 1.0
_NOTHING = 255
"""What Bullet's renderer leaves where it draws nothing."""
_FLAGS = pybullet.ER_NO_SEGMENTATION_MASK
# Bullet remembers the light of the last picture, so every picture states its own.
_LIGHT = {
    "lightDirection": (-1.5, -2.0, 4.0),
    "lightAmbientCoeff": 0.62,
    "lightDiffuseCoeff": 0.42,
    "lightSpecularCoeff": 0.05,
}


class OverheadCamera:
    """Takes pictures in which every pixel is the table's point at that pixel's centre."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        size = workspace.image_size
        self._bare_depth = np.full((size, size), CAMERA_HEIGHT, np.float32)
        self._bare_colours = np.broadcast_to(np.uint8(_NOTHING), (size, size, 3))
        self._view = pybullet.computeViewMatrix((0, 0, CAMERA_HEIGHT), (0, 0, 0), (0, 1, 0))

    def photograph(self, client: int) -> CameraFrame:
        """Picture of the world behind a Bullet connection; where nothing is, there is the table."""
        rgba, depth = self._draw(client, full_window(self._workspace))
        return CameraFrame(rgba[..., :3].copy(), depth.astype(np.float32), CAMERA_HEIGHT)

    def photograph_window(self, client: int, window: PixelWindow | None) -> CameraFrame:
        """The depth of the same picture, drawn in a window only; its colours are all white.

        Args:
            client: The Bullet connection.
            window: Where something can be seen; None where nothing is.
        """
        depth = self._bare_depth.copy()
        if window is not None:
            top, bottom, left, right = window
            depth[top:bottom, left:right] = self.photograph_part(client, window).depth
        return CameraFrame(self._bare_colours, depth, CAMERA_HEIGHT)

    def photograph_part(self, client: int, window: PixelWindow) -> CameraFrame:
        """Only the part of the picture that a window shows, its colours all white."""
        height, width = window.shape
        _, depth = self._draw(client, window)
        colours = self._bare_colours[:height, :width]
        return CameraFrame(colours, depth.astype(np.float32), CAMERA_HEIGHT)

    def _draw(
        self, client: int, window: PixelWindow
    ) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.float64]]:
        height, width = window.shape
        _, _, rgba, depth_buffer, _ = pybullet.getCameraImage(
            width,
            height,
            self._view,
            self._projection(window),
            shadow=0,
            renderer=pybullet.ER_TINY_RENDERER,
            flags=_FLAGS,
            **_LIGHT,
            physicsClientId=client,
        )
        buffer = np.asarray(depth_buffer, np.float64).reshape(height, width)
        depth = _FAR * _NEAR / (_FAR - (_FAR - _NEAR) * buffer)
        depth[buffer >= 1.0] = CAMERA_HEIGHT
        return np.asarray(rgba, np.uint8).reshape(height, width, 4), depth

    def _projection(self, window: PixelWindow) -> Sequence[float]:
        pixel, half = self._workspace.metres_per_pixel, self._workspace.half_length
        # The software renderer samples the lower left corner of each pixel; half a pixel of
        # shift makes that the centre.
        sides = (
            (window.left + 0.5) * pixel - half,
            (window.right + 0.5) * pixel - half,
            half - (window.bottom - 0.5) * pixel,
            half - (window.top - 0.5) * pixel,
        )
        scale = _NEAR / CAMERA_HEIGHT
        matrix: Sequence[float] = pybullet.computeProjectionMatrix(
            *(side * scale for side in sides), _NEAR, _FAR
        )
        return matrix


def picture(client: int, width: int, height: int, half_length: float) -> npt.NDArray[np.uint8]:
    """A view of the table for people, from the front and above, uint8 (height, width, 3)."""
    distance = 2.9 * half_length
    tilt = math.radians(58.0)
    view = pybullet.computeViewMatrix(
        (0.0, -distance * math.cos(tilt), distance * math.sin(tilt)),
        (0.0, -0.03 * half_length, 0.0),
        (0.0, 0.0, 1.0),
    )
    projection = pybullet.computeProjectionMatrixFOV(44.0, width / height, 0.1, 10.0)
    _, _, rgba, _, _ = pybullet.getCameraImage(
        width,
        height,
        view,
        projection,
        shadow=1,
        renderer=pybullet.ER_TINY_RENDERER,
        flags=_FLAGS,
        **_LIGHT,
        physicsClientId=client,
    )
    return np.asarray(rgba, np.uint8).reshape(height, width, 4)[..., :3].copy()
