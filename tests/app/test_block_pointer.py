"""From a drag of a block to its place and turn."""

import math

import pytest

from app.block_pointer import Grip
from app.commands import MoveBlock
from singulate.geometry import Workspace

GRIP = Grip(drag=3, centre=(0.1, 0.2), yaw=0.5, point=(0.15, 0.1, 0.2), picture_x=0.4)


def test_the_grabbed_point_stays_under_the_pointer() -> None:
    move = GRIP.moved_to((-0.25, 0.3), Workspace())
    assert move.drag == 3 and move.yaw is None
    assert move.place == pytest.approx((-0.3, 0.4))


def test_a_pointer_beside_the_table_leaves_the_block_at_its_edge() -> None:
    assert GRIP.moved_to((7.0, -9.0), Workspace()) == MoveBlock(3, place=(1.0, -1.0))


def test_a_pointer_that_goes_sideways_turns_the_block() -> None:
    move = GRIP.turned_to(0.65)
    assert move.place is None
    assert move.yaw == pytest.approx(0.5 + math.pi / 2)
