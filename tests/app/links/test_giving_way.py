"""Which coarse map is finished while a block is dragged."""

import pytest

from app.links.giving_way import GivingWay


@pytest.fixture
def way() -> GivingWay:
    """Maps that take 0.2 s."""
    way = GivingWay()
    for turn in range(40):
        way.begin(float(turn))
        way.finish(turn + 0.2)
    return way


@pytest.mark.parametrize(("after_s", "gives_way"), [(0.09, True), (0.11, False), (0.5, False)])
def test_a_map_gives_way_in_its_first_half(way: GivingWay, after_s: float, gives_way: bool) -> None:
    way.begin(100.0)
    assert way.give_way(100.0 + after_s) == gives_way


def test_the_one_after_it_does_not(way: GivingWay) -> None:
    way.begin(100.0)
    assert way.give_way(100.01)
    way.begin(100.01)
    assert not way.give_way(100.02)
    assert not way.give_way(100.03)
    way.finish(100.21)
    way.begin(100.21)
    assert way.give_way(100.22)


def test_what_is_usual_follows_the_machine(way: GivingWay) -> None:
    for turn in range(200, 240):
        way.begin(float(turn))
        way.finish(turn + 0.8)
    way.begin(300.0)
    assert way.give_way(300.39)
