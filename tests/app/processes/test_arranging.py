"""Hands on the blocks of the real interactive scene."""

from collections.abc import Iterator

import numpy as np
import pytest

from app.commands import AddBlock, HoldBlock, MoveBlock, ReleaseBlock, RemoveBlock, TurnBlock
from app.processes.arranging import MAX_BLOCKS
from app.processes.live_scene import LiveScene
from app.processes.scene_messages import SceneStart, StartPush
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push


@pytest.fixture
def scene() -> Iterator[LiveScene]:
    scene = LiveScene(SceneStart("fixed-2", 0))
    yield scene
    scene.close()


def drag(scene: LiveScene, number: int, index: int, *places: tuple[float, float]) -> None:
    scene.arrange(HoldBlock(number, index, "Ada"))
    for place in places:
        scene.arrange(MoveBlock(number, place))
    scene.arrange(ReleaseBlock(number))


def place_of(scene: LiveScene, index: int) -> tuple[float, float]:
    return scene.rest().scene.poses[index].position[:2]


def test_a_move_changes_the_picture_the_version_and_the_count_of_pushes(scene: LiveScene) -> None:
    before = scene.rest()
    scene.arrange(HoldBlock(1, 0, "Ada"))
    assert (scene.live().held_block, scene.live().held_by) == (0, "Ada")
    scene.arrange(MoveBlock(1, (-0.5, 0.5)))
    after = scene.rest()
    assert place_of(scene, 0) == pytest.approx((-0.5, 0.5))
    assert scene.live().poses == after.scene.poses
    assert after.version == before.version + 1
    assert after.scene.num_pushes == 0 and after.scene.is_rearranged
    assert not np.array_equal(after.percept.mask, before.percept.mask)
    assert after.is_success and not before.is_success
    scene.arrange(ReleaseBlock(1))
    assert scene.live().held_block is None


def test_a_drag_is_undone_as_one_step(scene: LiveScene) -> None:
    first = scene.rest().scene
    drag(scene, 1, 0, (-0.4, 0.2), (-0.5, 0.4), (-0.6, 0.6))
    second = scene.rest().scene
    drag(scene, 2, 1, (0.4, -0.2), (0.6, -0.6))
    scene.undo()
    assert scene.rest().scene == second
    scene.undo()
    assert scene.rest().scene == first


def test_taking_hold_and_letting_go_changes_nothing(scene: LiveScene) -> None:
    before = scene.rest()
    drag(scene, 1, 0)
    drag(scene, 2, 0, place_of(scene, 0))
    assert scene.rest() is before and not before.history


def test_the_last_command_about_a_block_decides(scene: LiveScene) -> None:
    scene.arrange(HoldBlock(1, 0, "Ada"))
    scene.arrange(HoldBlock(2, 0, "Bob"))
    assert scene.live().held_by == "Bob"
    scene.arrange(MoveBlock(2, (0.5, 0.5)))
    scene.arrange(MoveBlock(1, (-0.5, -0.5)))
    assert place_of(scene, 0) == pytest.approx((-0.5, -0.5))
    scene.arrange(ReleaseBlock(2))
    assert scene.live().held_by == "Ada"


def test_no_block_moves_by_hand_while_a_push_is_under_way(scene: LiveScene) -> None:
    scene.arrange(HoldBlock(1, 0, "Ada"))
    scene.begin(StartPush(Push.cardinal((0.0, -0.6), Direction.UP, 0.5), "you", 1))
    before = scene.rest()
    for command in (MoveBlock(1, (0.5, 0.5)), AddBlock(), TurnBlock(0, 0.3), RemoveBlock(0)):
        scene.arrange(command)
    while scene.step() is None:
        assert scene.rest() is before
    scene.arrange(MoveBlock(1, (0.5, 0.5)))
    assert place_of(scene, 0) != pytest.approx((0.5, 0.5)), "the push ended the drag"


def test_a_block_turns_and_makes_room_for_itself(scene: LiveScene) -> None:
    scene.arrange(TurnBlock(0, np.pi / 4))
    turned, other = scene.rest().scene.poses
    assert turned.yaw == pytest.approx(np.pi / 4)
    assert other.position[0] - turned.position[0] > 0.2 * (1.0 + np.sqrt(2.0)) / 2 - 1e-3
    scene.undo()
    scene.arrange(HoldBlock(1, 0, "Ada"))
    scene.arrange(MoveBlock(1, (-0.5, 0.5)))
    scene.arrange(MoveBlock(1, yaw=0.3))
    assert scene.rest().scene.poses[0].yaw == pytest.approx(0.3)
    assert place_of(scene, 0) == pytest.approx((-0.5, 0.5))


def test_blocks_are_added_and_removed_within_bounds(scene: LiveScene) -> None:
    while len(scene.rest().scene.poses) < MAX_BLOCKS:
        scene.arrange(AddBlock())
    assert scene.rest().percept.num_segments == MAX_BLOCKS - 1, "all but the first two are apart"
    with pytest.raises(InvalidValueError, match="1 to 10"):
        scene.arrange(AddBlock())
    while len(scene.rest().scene.poses) > 1:
        scene.arrange(RemoveBlock(0))
    with pytest.raises(InvalidValueError, match="1 to 10"):
        scene.arrange(RemoveBlock(0))
    scene.undo()
    assert len(scene.rest().scene.poses) == scene.rest().scene.num_blocks == 2


@pytest.mark.parametrize(
    "command",
    [
        HoldBlock(1, 2),
        HoldBlock(1, -1),
        HoldBlock(1, True),
        MoveBlock(7, (float("nan"), 0.0)),
        MoveBlock(7, (0.0, 1.5)),
        MoveBlock(7, "ab"),  # type: ignore[arg-type]
        MoveBlock(7, yaw=float("inf")),
        TurnBlock(0, float("nan")),
        TurnBlock(5, 0.1),
        RemoveBlock(9),
    ],
)
def test_what_cannot_be_is_refused_in_one_line_and_changes_nothing(
    scene: LiveScene, command: HoldBlock | MoveBlock | TurnBlock | RemoveBlock
) -> None:
    scene.arrange(HoldBlock(7, 0))
    before = scene.rest()
    with pytest.raises(InvalidValueError) as refusal:
        scene.arrange(command)
    assert "\n" not in str(refusal.value)
    assert scene.rest() is before
