"""Pushes that share a trajectory against pushes on their own."""

import dataclasses
import math

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import Block, Direction, Push, Workspace, standing_pose
from singulate.simulation import Physics, Scene
from singulate.simulation.shared_trajectory import SharedTrajectories

ROW = tuple(standing_pose(block) for block in (Block(-0.1, 0.0), Block(0.1, 0.0)))


def line(x: float, direction: Direction = Direction.UP, num: int = 12) -> list[Push]:
    """Starts along a line, from the near edge of the table to the far one."""
    ux, uy = direction.vector
    offsets = np.linspace(-0.9, 0.9, num)
    return [Push.cardinal((x * uy + t * ux, x * ux + t * uy), direction, 0.5) for t in offsets]


@pytest.fixture
def shared():
    with SharedTrajectories(Workspace(), Physics()) as shared:
        shared.place(ROW)
        yield shared


@pytest.mark.parametrize("direction", list(Direction))
@pytest.mark.parametrize("aside", [0.0, 0.08, -0.15])
def test_ends_are_those_of_single_pushes(
    scene: Scene, shared: SharedTrajectories, direction: Direction, aside: float
) -> None:
    scene.restore(ROW)
    pushes = [push for push in line(aside, direction) if not scene.is_blocked(push)]
    ends = {end.push_index: end.poses for end in shared.ends(pushes)}
    assert sorted(ends) == list(range(len(pushes)))
    errors = []
    for i, push in enumerate(pushes):
        scene.restore(ROW)
        scene.push(push)
        errors += [
            math.dist(found.position, expected.position)
            for found, expected in zip(ends[i], scene.poses, strict=True)
        ]
    assert np.median(errors) < 1e-3
    assert np.quantile(errors, 0.9) < 0.02


def test_a_push_that_ends_before_the_blocks_leaves_them_alone(shared: SharedTrajectories) -> None:
    (end,) = shared.ends([Push.cardinal((0.0, -0.9), Direction.UP, 0.5)])
    assert end.poses == ROW


def test_a_block_pushed_off_the_table_is_back_for_the_next_line(
    scene: Scene, shared: SharedTrajectories
) -> None:
    poses = (standing_pose(Block(0.0, 0.85)), standing_pose(Block(-0.5, 0.0)))
    shared.place(poses)
    (fallen,) = shared.ends([Push.cardinal((0.0, 0.65), Direction.UP, 0.5)])
    assert fallen.poses[0].position[2] < 0.0
    (end,) = shared.ends([Push.cardinal((-0.5, -0.3), Direction.UP, 0.5)])
    assert end.poses[0].position == pytest.approx((0.0, 0.85, 0.1), abs=1e-3)
    assert end.poses[1].position[1] == pytest.approx(0.335, abs=0.02)


def test_the_same_questions_have_the_same_answers(shared: SharedTrajectories) -> None:
    answers = []
    for _ in range(2):
        shared.place(ROW)
        answers.append([list(shared.ends(line(x)[:5])) for x in (0.05, -0.1, 0.2)])
    assert answers[0] == answers[1]


def test_pushes_of_several_lines_are_refused(shared: SharedTrajectories) -> None:
    with pytest.raises(InvalidValueError, match="on the line of"):
        list(shared.ends([line(0.0)[0], line(0.3)[0]]))


def test_an_end_at_which_the_physics_went_wrong_is_lost_and_no_other() -> None:
    physics = Physics()
    pushes = [Push.cardinal((0.0, y), Direction.UP, 0.5) for y in (-0.9, -0.5, -0.4)]
    with SharedTrajectories(Workspace(), physics) as shared:
        shared.place(ROW)
        before = {end.push_index: end.poses for end in shared.ends(pushes)}
        object.__setattr__(physics, "max_speed", 0.01)
        shared.place(ROW)
        wrong = {end.push_index: end.poses for end in shared.ends(pushes)}
        object.__setattr__(physics, "max_speed", dataclasses.fields(Physics)[-1].default)
        shared.place(ROW)
        after = {end.push_index: end.poses for end in shared.ends(pushes)}
    assert (wrong[1], wrong[2]) == (None, None)
    assert wrong[0] == before[0]
    assert before == after
    assert None not in after.values()
