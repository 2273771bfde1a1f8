import numpy as np

from singulate.geometry import CameraFrame
from singulate.perception import foreground_mask


def frame(depth: list[list[float]], camera_height: float = 2.0) -> CameraFrame:
    image = np.array(depth, dtype=np.float32)
    return CameraFrame(np.zeros((*image.shape, 3), np.uint8), image, camera_height)


def test_pixels_that_rise_above_the_table_are_objects() -> None:
    mask = foreground_mask(frame([[2.0, 1.8], [1.75, 2.0]]))
    assert mask.dtype == np.bool_
    assert mask.tolist() == [[False, True], [True, False]]


def test_default_height_separates_1_cm_from_3_cm() -> None:
    assert foreground_mask(frame([[1.99, 1.97]])).tolist() == [[False, True]]


def test_a_pixel_at_exactly_the_minimum_height_is_background() -> None:
    just_above = float(np.nextafter(np.float32(1.75), np.float32(0.0)))
    mask = foreground_mask(frame([[1.75, just_above]]), min_height=0.25)
    assert mask.tolist() == [[False, True]]


def test_below_the_table_is_background_however_deep() -> None:
    assert not foreground_mask(frame([[2.1, 50.0, np.inf]])).any()


def test_depth_that_is_not_a_number_is_background() -> None:
    assert foreground_mask(frame([[np.nan, 1.0]])).tolist() == [[False, True]]


def test_camera_height_is_what_counts() -> None:
    depth = [[1.0, 0.9]]
    assert foreground_mask(frame(depth, 1.0)).tolist() == [[False, True]]
    assert foreground_mask(frame(depth, 1.5)).tolist() == [[True, True]]
