"""All that the agent and the reward may know about a scene: what one picture shows."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from singulate.exceptions import InvalidValueError
from singulate.geometry import CameraFrame, Workspace
from singulate.perception.distance_map import distance_map
from singulate.perception.foreground import foreground_mask
from singulate.perception.segmentation import Segmentation
from singulate.perception.segments import label_segments
from singulate.perception.separation import segment_separations


@dataclass(frozen=True, eq=False)
class Percept(Segmentation):
    """What one picture of the table shows.

    Attributes:
        mask: Pixels that show objects, bool (H, W).
        label_image: 0 on the background, 1 to K on the segments, int32 (H, W).
    """

    mask: npt.NDArray[np.bool_]
    label_image: npt.NDArray[np.int32]

    @cached_property
    def distance_map(self) -> npt.NDArray[np.float32]:
        """Distance to the closest object, -1 inside, float32 (H, W) [px] (paper, section 3.1)."""
        return distance_map(self.mask)


def perceive(frame: CameraFrame, workspace: Workspace) -> Percept:
    """Preprocess one picture (paper, section 3.1).

    Args:
        frame: Picture from straight above that shows exactly the workspace.
        workspace: Gives the size of a pixel on the table.

    Returns:
        The mask, and what follows from it.

    Raises:
        InvalidValueError: If the picture does not have the workspace's number of pixels.
    """
    size = workspace.image_size
    if frame.depth.shape != (size, size):
        raise InvalidValueError("frame.depth", frame.depth.shape, f"an image of {size} x {size} px")
    return percept_of_mask(foreground_mask(frame), workspace.metres_per_pixel)


def percept_of_mask(mask: npt.NDArray[np.bool_], metres_per_pixel: float) -> Percept:
    """What follows from the pixels that show objects, bool (H, W)."""
    label_image = label_segments(mask)
    separations = segment_separations(label_image, metres_per_pixel)
    return Percept(int(label_image.max()), separations, mask, label_image)
