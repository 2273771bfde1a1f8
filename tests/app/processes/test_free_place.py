"""Where blocks come to stand that are moved by hand."""

import numpy as np
import pytest

from app.processes.free_place import free_place, nearest_free
from singulate.geometry import Block, Workspace
from singulate.geometry.rectangle import penetration

TABLE = Workspace()
START = Block(-0.6, 0.0, 0.2)


def test_a_free_place_is_taken_as_it_is() -> None:
    wanted = Block(0.3, -0.2, 0.2, 0.4)
    assert nearest_free(wanted, START, [Block(0.7, 0.7, 0.2).footprint], TABLE) == wanted


def test_a_block_stops_at_the_one_that_it_meets_and_slides_along_it() -> None:
    other = Block(0.0, 0.0, 0.2).footprint
    met = nearest_free(Block(-0.15, 0.03, 0.2), START, [other], TABLE)
    assert (met.x, met.y) == pytest.approx((-0.2, 0.03), abs=1e-4)


def test_a_block_stays_on_the_table_with_all_its_corners() -> None:
    at_corner = nearest_free(Block(1.0, -1.0, 0.2, np.pi / 4), START, [], TABLE)
    reach = 1.0 - 0.1 * np.sqrt(2.0)
    assert (at_corner.x, at_corner.y) == pytest.approx((reach, -reach))


def test_where_sliding_leads_nowhere_the_last_free_place_on_the_way_is_taken() -> None:
    walls = [Block(0.0, y, 0.25).footprint for y in (-0.875, -0.625, -0.375, -0.125)]
    walls += [Block(0.0, y, 0.25).footprint for y in (0.125, 0.375, 0.625, 0.875)]
    walls += [Block(x, y, 0.25).footprint for x in (0.25, -0.25) for y in (-0.125, 0.125)]
    stopped = nearest_free(Block(0.0, 0.0, 0.2), START, walls, TABLE)
    assert all(penetration(stopped.footprint, wall) <= 0.0 for wall in walls)
    assert (stopped.x, stopped.y) == pytest.approx((-0.475, 0.0), abs=1e-3)


def test_no_move_ever_ends_on_another_block_or_off_the_table() -> None:
    rng = np.random.default_rng(0)
    for _ in range(200):
        others = [Block(*rng.uniform(-0.8, 0.8, 2), 0.2, rng.uniform(0.0, 1.5)) for _ in range(4)]
        start = free_place(0.2, [other.footprint for other in others], TABLE, 0.0)
        assert start is not None
        wanted = Block(*rng.uniform(-1.0, 1.0, 2), 0.2, rng.uniform(-1.5, 1.5))
        moved = nearest_free(wanted, start, [other.footprint for other in others], TABLE)
        assert all(penetration(moved.footprint, other.footprint) <= 0.0 for other in others)
        assert np.abs(moved.footprint).max() <= TABLE.half_length + 1e-9


def test_a_new_block_stands_near_the_middle_and_apart_from_the_others() -> None:
    others = [Block(0.0, 0.0, 0.2).footprint]
    placed = free_place(0.2, others, TABLE, gap=0.1)
    assert placed is not None
    assert max(abs(placed.x), abs(placed.y)) == pytest.approx(0.3, abs=0.05)


def test_a_full_table_has_no_free_place() -> None:
    assert free_place(0.2, [Block(0.0, 0.0, 2.0).footprint], TABLE, 0.0) is None
