import math

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push


@pytest.mark.parametrize(
    ("direction", "end"),
    [
        (Direction.UP, (0.1, 0.7)),
        (Direction.RIGHT, (0.6, 0.2)),
        (Direction.DOWN, (0.1, -0.3)),
        (Direction.LEFT, (-0.4, 0.2)),
    ],
)
def test_cardinal_pushes_end_where_they_should(
    direction: Direction, end: tuple[float, float]
) -> None:
    push = Push.cardinal((0.1, 0.2), direction, 0.5)
    assert push.end == pytest.approx(end)
    assert push.nearest_direction is direction


def test_push_between_two_points() -> None:
    push = Push.between((0.0, 0.0), (0.3, 0.4))
    assert push.length == pytest.approx(0.5)
    assert push.direction == pytest.approx((0.6, 0.8))
    assert push.end == pytest.approx((0.3, 0.4))
    assert push.yaw == pytest.approx(math.atan2(4, 3))
    assert push.nearest_direction is Direction.UP


def test_push_between_equal_points_has_length_0() -> None:
    push = Push.between((0.2, -0.1), (0.2, -0.1))
    assert (push.length, push.end) == (0.0, (0.2, -0.1))


@pytest.mark.parametrize("seed", range(5))
def test_between_is_the_inverse_of_end(seed: int) -> None:
    x, y, u, v = np.random.default_rng(seed).uniform(-1.0, 1.0, 4)
    push = Push.between((x, y), (u, v))
    assert push.end == pytest.approx((u, v))
    assert math.hypot(*push.direction) == pytest.approx(1.0)


@pytest.mark.parametrize("yaw_deg", range(-170, 181, 20))
def test_nearest_direction_lies_within_45_degrees(yaw_deg: int) -> None:
    yaw = math.radians(yaw_deg)
    push = Push((0.0, 0.0), (math.cos(yaw), math.sin(yaw)), 1.0)
    x, y = push.nearest_direction.vector
    assert x * math.cos(yaw) + y * math.sin(yaw) >= math.sqrt(0.5) - 1e-9
    assert math.cos(push.yaw - yaw) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("start", "direction", "length", "key"),
    [
        ((math.nan, 0.0), (1.0, 0.0), 0.5, "push.start"),
        ((0.0, math.inf), (1.0, 0.0), 0.5, "push.start"),
        ((0.0, 0.0), (1.0, 1.0), 0.5, "push.direction"),
        ((0.0, 0.0), (0.0, 0.0), 0.5, "push.direction"),
        ((0.0, 0.0), (math.nan, 0.0), 0.5, "push.direction"),
        ((0.0, 0.0), (1.0, 0.0), -0.1, "push.length"),
        ((0.0, 0.0), (1.0, 0.0), math.inf, "push.length"),
        ((0.0, 0.0), (1.0, 0.0), math.nan, "push.length"),
    ],
)
def test_impossible_pushes_are_refused(
    start: tuple[float, float], direction: tuple[float, float], length: float, key: str
) -> None:
    with pytest.raises(InvalidValueError) as caught:
        Push(start, direction, length)
    assert caught.value.key == key
