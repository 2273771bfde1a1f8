"""Blocks moved by hand: one table for all, one undo step a drag, every field follows."""

import math

import numpy as np
import pytest

from app.commands import (
    AddBlock,
    HoldBlock,
    MoveBlock,
    PushNow,
    ReleaseBlock,
    RemoveBlock,
    ResetScene,
    SetSpeed,
    TurnBlock,
    Undo,
)
from singulate.geometry import Direction, Push


@pytest.fixture(scope="module")
def bench(make_bench):
    return make_bench(scenario="fixed-2", seed=0)


@pytest.fixture(autouse=True)
def fresh_scene(bench):
    version = bench.snapshot.scene.version
    bench.do(SetSpeed(8.0), ResetScene("fixed-2", 0))
    bench.until(lambda s: s.scene.version > version and s.scene.speed == 8.0)


def arrange(bench, *commands):
    version = bench.snapshot.scene.version
    bench.do(*commands)
    return bench.until(lambda s: s.scene.version > version).scene


def place(scene, index=0):
    return scene.poses[index].position[:2]


def test_a_drag_moves_a_block_and_pictures_and_state_follow(bench):
    before = bench.snapshot.scene
    bench.do(HoldBlock(1, 0, "visitor 1"), MoveBlock(1, place=(-0.5, 0.4)))
    held = bench.until(lambda s: s.scene.version > before.version).scene
    assert place(held) == pytest.approx((-0.5, 0.4))
    assert (held.held_block, held.held_by) == (0, "visitor 1")
    assert held.num_segments == 2 and held.is_success and held.is_rearranged
    assert not np.array_equal(held.distance_map, before.distance_map)
    bench.do(ReleaseBlock(1))
    bench.until(lambda s: s.scene.held_block is None)


def test_a_whole_drag_is_one_step_of_undo(bench):
    before = bench.snapshot.scene
    bench.do(HoldBlock(2, 0))
    for x in (-0.3, -0.4, -0.5):
        moved = arrange(bench, MoveBlock(2, place=(x, 0.3)))
    bench.do(ReleaseBlock(2))
    assert moved.can_undo
    back = arrange(bench, Undo())
    assert back.poses == before.poses
    assert not back.can_undo and not back.is_rearranged


def test_undo_ends_a_drag(bench):
    arrange(bench, HoldBlock(3, 0), MoveBlock(3, place=(-0.5, 0.5)))
    back = arrange(bench, Undo())
    bench.do(MoveBlock(3, place=(0.5, 0.5)))
    assert bench.run(0.2)[-1].scene.version == back.version
    assert back.held_block is None


def test_a_push_ends_a_drag_and_no_block_is_moved_meanwhile(bench):
    push = Push.cardinal((-0.6, 0.6), Direction.RIGHT, 0.5)
    bench.do(SetSpeed(0.5), HoldBlock(4, 0), PushNow(push))
    bench.until(lambda s: s.scene.is_pushing)
    bench.do(MoveBlock(4, place=(0.5, 0.5)), HoldBlock(5, 0), MoveBlock(5, place=(0.5, 0.5)))
    bench.do(AddBlock(), SetSpeed(8.0))
    after = bench.until(lambda s: not s.scene.is_pushing).scene
    assert place(after) == pytest.approx((-0.1, 0.0))
    assert len(after.poses) == 2 and after.held_block is None


def test_two_people_may_hold_the_same_block(bench):
    arrange(bench, HoldBlock(6, 0, "a"), MoveBlock(6, place=(-0.5, 0.5)))
    last = arrange(bench, HoldBlock(7, 0, "b"), MoveBlock(7, place=(-0.5, -0.5)))
    assert place(last) == pytest.approx((-0.5, -0.5)) and last.held_by == "b"
    last = arrange(bench, MoveBlock(6, place=(0.6, 0.5)))
    assert place(last) == pytest.approx((0.6, 0.5))
    bench.do(ReleaseBlock(7))
    assert bench.until(lambda s: s.scene.held_by == "a").scene.held_block == 0


def test_a_block_turns_and_gives_way_to_the_one_it_touches(bench):
    turned = arrange(bench, TurnBlock(0, math.radians(30.0)))
    assert turned.poses[0].yaw == pytest.approx(math.radians(30.0))
    assert turned.poses[0].position[0] < -0.1


def test_blocks_are_added_and_removed_up_to_ten_and_down_to_one(bench):
    for number in range(3, 11):
        assert arrange(bench, AddBlock()).num_blocks == number
    full = bench.snapshot.scene
    known = set(bench.texts)
    bench.do(AddBlock())
    bench.until(lambda s: set(bench.texts) - known)
    assert len(bench.snapshot.scene.poses) == 10
    assert arrange(bench, RemoveBlock(0)).poses == full.poses[1:]
    assert arrange(bench, Undo()).poses == full.poses
    for _ in range(9):
        alone = arrange(bench, RemoveBlock(0))
    assert alone.num_segments == 1
    bench.do(RemoveBlock(0))
    bench.until(lambda s: any("0 blocks" in text for text in bench.texts))


def test_what_was_arranged_can_be_pushed(bench):
    arrange(bench, HoldBlock(8, 0), MoveBlock(8, place=(-0.6, 0.0)), ReleaseBlock(8))
    arrange(bench, RemoveBlock(1))
    after = arrange(bench, PushNow(Push.cardinal((-0.6, -0.4), Direction.UP, 0.5)))
    after = bench.until(lambda s: not s.scene.is_pushing).scene
    assert after.poses[0].position[1] > 0.05 and after.last_push is not None


@pytest.mark.parametrize(
    ("commands", "word"),
    [
        ((HoldBlock(9, 2),), "block"),
        ((HoldBlock(9, -1),), "block"),
        ((HoldBlock(9, True),), "block"),
        ((HoldBlock(9, "0"),), "block"),
        ((HoldBlock(9, 0), MoveBlock(9, place=(math.nan, 0.0))), "place"),
        ((HoldBlock(9, 0), MoveBlock(9, place=(1.5, 0.0))), "place"),
        ((HoldBlock(9, 0), MoveBlock(9, place=(0.1, 0.2, 0.3))), "place"),
        ((HoldBlock(9, 0), MoveBlock(9, yaw=math.inf)), "yaw"),
        ((TurnBlock(0, "far"),), "angle"),
        ((TurnBlock(5, 0.1),), "block"),
        ((RemoveBlock(None),), "block"),
    ],
)
def test_a_bad_value_is_one_line_and_moves_nothing(bench, commands, word):
    before = bench.snapshot.scene
    known = set(bench.texts)
    bench.do(*commands)
    bench.until(lambda s: set(bench.texts) - known)
    (text,) = set(bench.texts) - known
    assert word in text and "\n" not in text
    assert bench.run(0.1)[-1].scene.version == before.version
    bench.do(ReleaseBlock(9))
