"""What the reward counts in a picture: its segments, and how far apart they are."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from singulate.geometry import CameraFrame
from singulate.perception.foreground import foreground_mask
from singulate.perception.inter_object_distance import (
    inter_object_distance,
    truncated_inter_object_distance,
)
from singulate.perception.segments import connected_regions
from singulate.perception.separation import mask_separations


@dataclass(frozen=True, eq=False)
class Segmentation:
    """How many segments a picture shows, and their separations.

    Attributes:
        num_segments: How many objects the picture can tell apart, K.
        separations: Edge-to-edge distance of every pair of segments, (K * (K - 1) / 2,) [m].
    """

    num_segments: int
    separations: npt.NDArray[np.float64]

    @property
    def inter_object_distance(self) -> float:
        """d_IO, the sum of all separations [m] (paper, Eq. 1)."""
        return inter_object_distance(self.separations)

    def inter_object_distance_truncated(self, goal: float) -> float:
        """d_IOT, the sum of all separations, each counted up to `goal` [m] (paper, Eq. 2)."""
        return truncated_inter_object_distance(self.separations, goal)


def segment(frame: CameraFrame, metres_per_pixel: float) -> Segmentation:
    """Segment a picture, or the part of one in which all objects are.

    Args:
        frame: Picture from straight above, of any size.
        metres_per_pixel: Side of a pixel on the table [m].

    Returns:
        The same as `perceive` finds in the whole picture.
    """
    num_segments, label_image = connected_regions(foreground_mask(frame))
    masks = [(label_image == k).view(np.uint8) for k in range(1, num_segments + 1)]
    return Segmentation(num_segments, mask_separations(masks, metres_per_pixel))
