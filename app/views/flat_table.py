"""The table as a flat picture from above, drawn without a browser's help."""

import cv2
import numpy as np
import numpy.typing as npt

from app.fields.resample import nearest
from app.views.palette import BLOCK_COLOURS
from singulate.geometry import BlockPose, Poses, Workspace

SIZE = 640
"""Pixels along each side: a multiple of a draped field's."""
_SHIFT = 4
"""Binary places of a pixel that corners are given with."""


def flat_table(
    poses: Poses, field: npt.NDArray[np.uint8] | None, workspace: Workspace
) -> npt.NDArray[np.uint8]:
    """Draw the blocks on what is laid over the workspace.

    Args:
        poses: Of all blocks; those that fell off the table are not drawn.
        field: RGBA uint8 (H, H, 4), row 0 at +y; None for a bare table.
        workspace: The square that the picture covers.

    Returns:
        RGBA uint8 (SIZE, SIZE, 4), row 0 at +y, transparent where the table is bare.
    """
    picture = np.zeros((SIZE, SIZE, 4), dtype=np.uint8)
    if field is not None:
        picture[:] = nearest(field, SIZE)
    for index, pose in enumerate(poses):
        if pose.position[2] > 0.0:
            colour = (*BLOCK_COLOURS[index % len(BLOCK_COLOURS)], 255)
            corners = np.round(_corners(pose, workspace) * 2**_SHIFT).astype(np.int32)
            cv2.fillConvexPoly(picture, corners, colour, cv2.LINE_AA, _SHIFT)
    return picture


def _corners(pose: BlockPose, workspace: Workspace) -> npt.NDArray[np.float64]:
    """Columns and rows of a standing block's corners, (4, 2)."""
    half = pose.side / 2 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    cosine, sine = np.cos(pose.yaw), np.sin(pose.yaw)
    xy: npt.NDArray[np.float64] = (
        half @ np.array([[cosine, sine], [-sine, cosine]]) + pose.position[:2]
    )
    return (xy * (1.0, -1.0) + workspace.half_length) * SIZE / workspace.length - 0.5
