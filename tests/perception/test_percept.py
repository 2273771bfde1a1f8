import dataclasses
import pickle

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import CameraFrame, Workspace
from singulate.perception import Percept, perceive

CAMERA_HEIGHT = 3.0


def frame(*corners: tuple[int, int], side: int = 6, size: int = 64) -> CameraFrame:
    """A picture of cubes of 0.2 m whose upper left pixels are given."""
    depth = np.full((size, size), CAMERA_HEIGHT, np.float32)
    for row, col in corners:
        depth[row : row + side, col : col + side] = CAMERA_HEIGHT - 0.2
    return CameraFrame(np.zeros((size, size, 3), np.uint8), depth, CAMERA_HEIGHT)


def test_three_blocks() -> None:
    percept = perceive(frame((20, 10), (20, 20), (20, 28)), Workspace())
    assert percept.mask.sum() == 108
    assert percept.num_segments == 3
    # 4, 12 and 2 px of background, 31.25 mm each.
    np.testing.assert_allclose(percept.separations, [0.125, 0.375, 0.0625], rtol=1e-12)
    assert percept.inter_object_distance == pytest.approx(0.5625)
    assert percept.inter_object_distance_truncated(0.1) == pytest.approx(0.2625)


def test_arrays_have_the_documented_types_and_shapes() -> None:
    percept = perceive(frame((20, 10), (20, 20)), Workspace())
    expected = {
        "mask": ("bool", (64, 64)),
        "distance_map": ("float32", (64, 64)),
        "label_image": ("int32", (64, 64)),
        "separations": ("float64", (1,)),
    }
    for name, dtype_and_shape in expected.items():
        array = getattr(percept, name)
        assert (array.dtype.name, array.shape) == dtype_and_shape


def test_mask_distance_map_and_labels_agree() -> None:
    percept = perceive(frame((3, 3), (40, 41), (50, 8)), Workspace())
    np.testing.assert_array_equal(percept.label_image > 0, percept.mask)
    np.testing.assert_array_equal(percept.distance_map == -1.0, percept.mask)
    assert percept.distance_map[3, 9] == 1.0
    assert percept.distance_map[3, 13] == 5.0


def test_blocks_that_touch_are_one_segment() -> None:
    percept = perceive(frame((20, 20), (20, 26), (20, 32)), Workspace())
    assert percept.num_segments == 1
    assert percept.separations.shape == (0,)
    assert percept.inter_object_distance_truncated(0.1) == 0.0


def test_an_empty_table() -> None:
    percept = perceive(frame(), Workspace())
    assert percept.num_segments == 0
    assert percept.inter_object_distance == 0.0
    assert percept.distance_map.min() == pytest.approx(90.50967, abs=1e-4)


def test_the_workspace_sets_the_scale() -> None:
    percept = perceive(frame((1, 1), (1, 11), size=32), Workspace(half_length=0.8, image_size=32))
    assert percept.separations == pytest.approx([4 * 0.05])


@pytest.mark.parametrize("size", [32, 65])
def test_a_picture_of_another_size_is_refused(size: int) -> None:
    with pytest.raises(InvalidValueError, match=r"frame\.depth: .*64 x 64 px"):
        perceive(frame(size=size), Workspace())


def test_equal_pictures_give_equal_bits_before_and_after_pickling() -> None:
    first, second = (perceive(frame((20, 10), (31, 17)), Workspace()) for _ in range(2))
    copy: Percept = pickle.loads(pickle.dumps(first))
    for other in (second, copy):
        for name in ("mask", "distance_map", "label_image", "separations"):
            assert getattr(first, name).tobytes() == getattr(other, name).tobytes()


def test_a_percept_cannot_be_changed() -> None:
    percept = perceive(frame((20, 10)), Workspace())
    with pytest.raises(dataclasses.FrozenInstanceError):
        percept.mask = np.zeros((64, 64), bool)  # type: ignore[misc]


def test_does_not_change_the_picture() -> None:
    picture = frame((20, 10))
    before = picture.depth.copy()
    perceive(picture, Workspace())
    np.testing.assert_array_equal(picture.depth, before)
