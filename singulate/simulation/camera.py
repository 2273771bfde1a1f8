"""The fixed RGB-D camera straight above the table."""

import math

import numpy as np
import numpy.typing as npt

from singulate.geometry import CameraFrame, Workspace
from singulate.simulation.bullet import pybullet

CAMERA_HEIGHT = 20.0
"""Height above the table [m]; from here a block of 0.2 m leans outward by at most 1 % of its
distance from the centre, a third of a pixel at the border."""

_NEAR = CAMERA_HEIGHT - 1.0
_FAR = CAMERA_HEIGHT + 1.0
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
        self._size = workspace.image_size
        self._view = pybullet.computeViewMatrix((0, 0, CAMERA_HEIGHT), (0, 0, 0), (0, 1, 0))
        # The software renderer samples the lower left corner of each pixel; half a pixel of
        # shift makes that the centre.
        half, shift = workspace.half_length, workspace.metres_per_pixel / 2
        scale = _NEAR / CAMERA_HEIGHT
        self._projection = pybullet.computeProjectionMatrix(
            (shift - half) * scale,
            (shift + half) * scale,
            (shift - half) * scale,
            (shift + half) * scale,
            _NEAR,
            _FAR,
        )

    def photograph(self, client: int) -> CameraFrame:
        """Picture of the world behind a Bullet connection; where nothing is, there is the table."""
        size = self._size
        _, _, rgba, depth_buffer, _ = pybullet.getCameraImage(
            size,
            size,
            self._view,
            self._projection,
            shadow=0,
            renderer=pybullet.ER_TINY_RENDERER,
            flags=_FLAGS,
            **_LIGHT,
            physicsClientId=client,
        )
        rgb = np.asarray(rgba, np.uint8).reshape(size, size, 4)[..., :3].copy()
        buffer = np.asarray(depth_buffer, np.float64).reshape(size, size)
        depth = _FAR * _NEAR / (_FAR - (_FAR - _NEAR) * buffer)
        depth[buffer >= 1.0] = CAMERA_HEIGHT
        return CameraFrame(rgb, depth.astype(np.float32), CAMERA_HEIGHT)


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
