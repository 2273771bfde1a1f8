"""From rays and drags to places on the table."""

import math

import pytest

from app.aim import Aim, aim_of_drag
from app.pointer import table_point
from singulate.geometry import Direction, Workspace


def test_a_ray_meets_the_table_where_it_should() -> None:
    assert table_point((0.0, -1.0, 2.0), (0.0, 0.5, -1.0)) == pytest.approx((0.0, 0.0))
    assert table_point((1.0, 1.0, 1.0), (-1.0, 0.0, -2.0)) == pytest.approx((0.5, 1.0))


def test_rays_along_or_away_from_the_table_miss_it() -> None:
    assert table_point((0.0, 0.0, 1.0), (1.0, 0.0, 0.0)) is None
    assert table_point((0.0, 0.0, 1.0), (0.0, 0.0, 1.0)) is None


@pytest.mark.parametrize("direction", Direction)
def test_a_drag_takes_the_nearest_of_the_four_directions(direction: Direction) -> None:
    x, y = direction.vector
    turned = (x * math.cos(0.6) - y * math.sin(0.6), x * math.sin(0.6) + y * math.cos(0.6))
    start = (0.2, -0.1)
    end = (start[0] + 0.3 * turned[0], start[1] + 0.3 * turned[1])
    assert aim_of_drag(start, end, Workspace()) == Aim(start, direction)


def test_slips_of_the_hand_and_starts_beside_the_table_are_no_arrows() -> None:
    assert aim_of_drag((0.0, 0.0), (0.02, 0.0), Workspace()) is None
    assert aim_of_drag((1.1, 0.0), (0.5, 0.0), Workspace()) is None


def test_an_aim_stands_for_a_push_of_the_papers_length() -> None:
    push = Aim((0.1, 0.2), Direction.LEFT).push(Workspace())
    assert push is not None
    assert (push.start, push.direction, push.length) == ((0.1, 0.2), (-1.0, 0.0), 0.5)
    assert Aim().push(Workspace()) is None
