"""What the overhead camera delivers."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt


class CameraFrame(NamedTuple):
    """One picture of the table from straight above; row 0 is +y, column 0 is -x.

    Attributes:
        rgb: Colours, uint8 (H, W, 3).
        depth: Distance from the camera along its axis, float32 (H, W) [m].
        camera_height: Height of the camera above the table [m].
    """

    rgb: npt.NDArray[np.uint8]
    depth: npt.NDArray[np.float32]
    camera_height: float
