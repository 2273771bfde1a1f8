"""From a depth image to the pixels that show objects (paper, section 3.1)."""

import numpy as np
import numpy.typing as npt

from singulate.geometry import CameraFrame

MIN_HEIGHT = 0.02
"""What rises less than this above the table counts as table [m]."""


def foreground_mask(frame: CameraFrame, min_height: float = MIN_HEIGHT) -> npt.NDArray[np.bool_]:
    """Pixels whose surface lies more than `min_height` above the table.

    What lies below the table's plane (the floor beside it, a block that fell off), and depths that
    are not numbers, are background.

    Args:
        frame: Picture from straight above; only its depth is used.
        min_height: Height above the table that a pixel has to exceed [m].

    Returns:
        bool (H, W), True on objects.

    Example:
        >>> depth = np.array([[1.5, 1.25], [1.499, 9.0]], dtype=np.float32)
        >>> frame = CameraFrame(np.zeros((2, 2, 3), np.uint8), depth, camera_height=1.5)
        >>> foreground_mask(frame).tolist()
        [[False, True], [False, False]]
    """
    return frame.depth < frame.camera_height - min_height
