"""Blocks that are put up are at rest in Bullet."""

import math

import pytest

from singulate.geometry import Block, BlockPose, Workspace, standing_pose
from singulate.simulation.bullet import pybullet
from singulate.simulation.physics import Physics
from singulate.simulation.resting import resting_place
from singulate.simulation.world import World


@pytest.fixture
def world():
    world = World(Workspace(), Physics())
    yield world
    world.close()


def angle_between(one: BlockPose, other: BlockPose) -> float:
    """How far one is turned against the other [rad]."""
    vector = [a - b for a, b in zip(one.quaternion, other.quaternion, strict=True)]
    return 2.0 * math.hypot(*vector)


@pytest.mark.parametrize("side", [0.15, 0.2, 0.25])
@pytest.mark.parametrize("yaw", [0.0, 0.3, -0.7])
def test_a_block_from_a_layout_neither_sinks_nor_leans_over(world, side, yaw):
    world.build((standing_pose(Block(0.3, -0.2, side, yaw)),))
    (before,) = world.block_poses()
    world.step(60)
    (after,) = world.block_poses()
    assert after.position[2] == pytest.approx(before.position[2], abs=2e-7)
    assert angle_between(before, after) < 2e-5
    assert math.dist(before.position, after.position) < 4e-6


def test_blocks_face_to_face_are_not_in_contact(world):
    world.build(tuple(standing_pose(Block(0.2 * i, 0.1)) for i in range(3)))
    world.step(60)
    touched = {point[1:3] for point in pybullet.getContactPoints(physicsClientId=world.client)}
    table = 0
    assert len(touched) == 3
    assert all(table in pair for pair in touched)


def test_a_turned_block_leans_about_its_own_axis():
    straight, turned = (
        BlockPose(*resting_place(standing_pose(Block(0.0, 0.0, 0.2, yaw))), 0.2)
        for yaw in (0.0, 0.5)
    )
    assert turned.position == straight.position
    assert turned.yaw == pytest.approx(0.5)
    assert math.hypot(*turned.quaternion) == pytest.approx(1.0)
    assert math.hypot(*turned.quaternion[:2]) == pytest.approx(math.hypot(*straight.quaternion[:2]))


@pytest.mark.parametrize(
    "pose",
    [
        BlockPose((0.1, 0.2, 0.099985), (3e-6, -2e-5, 0.0, 1.0), 0.2),
        BlockPose((0.1, 0.2, 0.3), (0.0, 0.0, 0.0, 1.0), 0.2),
    ],
    ids=["left by Bullet", "on another block"],
)
def test_other_poses_stay_as_they_are(pose):
    assert resting_place(pose) == (pose.position, pose.quaternion)
