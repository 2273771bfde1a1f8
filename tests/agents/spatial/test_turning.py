import numpy as np
import pytest

from singulate.agents.spatial.turning import (
    from_turned_pixel,
    to_turned_pixels,
    turn_all_ways,
    turn_back,
    turn_each,
)
from singulate.geometry import Direction, Push, Workspace

WORKSPACE = Workspace()


@pytest.mark.parametrize("direction", Direction)
def test_a_push_points_up_in_its_turned_picture(direction: Direction) -> None:
    push = Push.cardinal((0.2, -0.35), direction, 0.5)
    picture = np.zeros((1, 64, 64), dtype=np.float32)
    for value, point in ((1.0, push.start), (2.0, push.end)):
        picture[(0, *WORKSPACE.xy_to_row_col(*point))] = value
    turned = turn_each(picture, np.array([direction]))[0]
    start, end = (np.argwhere(turned == value)[0] for value in (1.0, 2.0))
    assert start[0] - end[0] == 16
    assert start[1] == end[1]
    pixel = to_turned_pixels(np.array([push.start]), np.array([direction]), 64)[0]
    assert np.rint(pixel).tolist() == start.tolist()


@pytest.mark.parametrize("direction", Direction)
def test_pixels_lead_back_to_starts(direction: Direction) -> None:
    start = (0.123, -0.987)
    row, column = to_turned_pixels(np.array([start]), np.array([direction]), 64)[0]
    assert from_turned_pixel(row, column, direction, 64) == pytest.approx(start)


def test_maps_of_all_directions_are_turned_back() -> None:
    image = np.random.default_rng(0).random((8, 8), dtype=np.float32)
    assert np.array_equal(turn_back(turn_all_ways(image)), np.stack([image] * 4))


def test_each_picture_is_turned_by_its_own_direction() -> None:
    images = np.random.default_rng(0).random((5, 8, 8), dtype=np.float32)
    directions = np.array([3, 0, 1, 2, 1])
    expected = [turn_all_ways(image)[d] for image, d in zip(images, directions, strict=True)]
    assert np.array_equal(turn_each(images, directions), np.stack(expected))
