import math

import numpy as np
import pytest

from singulate.geometry.rectangle import Polygon, distance, penetration, rectangle


def square(x: float, y: float, side: float = 1.0, yaw: float = 0.0) -> Polygon:
    return rectangle((x, y), (side / 2, side / 2), yaw)


def random_square(rng: np.random.Generator) -> Polygon:
    x, y, side, yaw = rng.uniform([-1.0, -1.0, 0.2, -3.0], [1.0, 1.0, 1.0, 3.0])
    return square(x, y, side, yaw)


def test_corners_run_counter_clockwise() -> None:
    corners = rectangle((1.0, 2.0), (2.0, 0.5), 0.0)
    np.testing.assert_allclose(corners, [[3, 2.5], [-1, 2.5], [-1, 1.5], [3, 1.5]])


def test_a_quarter_turn_swaps_the_sides() -> None:
    corners = rectangle((0.0, 0.0), (2.0, 0.5), math.pi / 2)
    np.testing.assert_allclose(corners, [[-0.5, 2], [-0.5, -2], [0.5, -2], [0.5, 2]], atol=1e-12)


def test_a_turned_corner_points_along_x() -> None:
    corner = square(0.0, 0.0, 2.0, yaw=-math.pi / 4)[0]
    np.testing.assert_allclose(corner, [math.sqrt(2), 0.0], atol=1e-12)


@pytest.mark.parametrize(("x", "overlap"), [(0.75, 0.25), (1.0, 0.0), (1.5, -0.5)])
def test_penetration_of_squares_side_by_side(x: float, overlap: float) -> None:
    assert penetration(square(0, 0), square(x, 0.1)) == pytest.approx(overlap, abs=1e-12)


@pytest.mark.parametrize(
    ("x", "y", "expected"),
    [(1.5, 0.0, 0.5), (1.5, 0.9, 0.5), (1.3, 1.4, 0.5), (0.5, 0.5, 0.0), (1.0, 0.0, 0.0)],
)
def test_distance_between_axis_parallel_squares(x: float, y: float, expected: float) -> None:
    assert distance(square(0, 0), square(x, y)) == pytest.approx(expected, abs=1e-12)


def test_distance_from_an_edge_to_a_turned_corner() -> None:
    turned = square(2.0, 0.0, 1.0, yaw=math.pi / 4)
    assert distance(square(0, 0), turned) == pytest.approx(1.5 - math.sqrt(0.5))


def test_one_inside_the_other_has_distance_0() -> None:
    assert distance(square(0, 0, 4.0), square(0.3, 0.2, 0.5, yaw=0.4)) == 0.0


@pytest.mark.parametrize("seed", range(20))
def test_distance_is_symmetric_and_positive_exactly_without_overlap(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = random_square(rng), random_square(rng)
    assert distance(a, b) == pytest.approx(distance(b, a), abs=1e-12)
    assert penetration(a, b) == pytest.approx(penetration(b, a), abs=1e-12)
    assert (distance(a, b) > 0.0) == (penetration(a, b) < 0.0)


@pytest.mark.parametrize("seed", range(20))
def test_distance_equals_that_of_densely_sampled_outlines(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = random_square(rng), random_square(rng) + np.array([0.3, 2.8])
    along = np.linspace(0.0, 1.0, 200)[:, None, None]
    outlines = [((1 - along) * p + along * np.roll(p, -1, axis=0)).reshape(-1, 2) for p in (a, b)]
    gaps = outlines[0][:, None] - outlines[1]
    sampled = np.sqrt((gaps**2).sum(axis=-1).min())
    assert penetration(a, b) < 0.0
    assert distance(a, b) == pytest.approx(sampled, abs=0.005)
    assert distance(a, b) <= sampled + 1e-12
