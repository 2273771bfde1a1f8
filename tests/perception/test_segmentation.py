"""Segments and separations from a part of a picture."""

import numpy as np
import pytest

from singulate.geometry import CameraFrame, Workspace
from singulate.perception import perceive, segment

WORKSPACE = Workspace(image_size=16)


def frame(objects: np.ndarray) -> CameraFrame:
    depth = np.where(objects, 1.0, 1.5).astype(np.float32)
    return CameraFrame(np.zeros((*depth.shape, 3), np.uint8), depth, camera_height=1.5)


@pytest.mark.parametrize("seed", range(20))
def test_a_part_that_shows_all_objects_counts_as_the_whole_picture(seed: int) -> None:
    rng = np.random.default_rng(seed)
    objects = np.zeros((16, 16), np.bool_)
    objects[3:12, 5:14] = rng.random((9, 9)) < rng.uniform(0.0, 0.5)
    whole = perceive(frame(objects), WORKSPACE)
    part = segment(frame(objects[2:13, 5:15]), WORKSPACE.metres_per_pixel)
    assert part.num_segments == whole.num_segments
    assert part.separations.tolist() == whole.separations.tolist()
    assert part.inter_object_distance_truncated(0.1) == whole.inter_object_distance_truncated(0.1)


@pytest.mark.parametrize("objects", [np.zeros((1, 1), np.bool_), np.ones((2, 3), np.bool_)])
def test_without_a_pair_nothing_is_apart(objects: np.ndarray) -> None:
    segmentation = segment(frame(objects), 0.1)
    assert segmentation.num_segments == int(objects.any())
    assert segmentation.separations.shape == (0,)
    assert segmentation.inter_object_distance == 0.0
