"""Blocks that slide to a stop."""

import math
from collections.abc import Iterator

import pytest

from singulate.exceptions import SimulationError
from singulate.geometry import Block, Workspace, standing_pose
from singulate.simulation import Physics
from singulate.simulation.motion import BlockMotion, TopSpeeds, fastest
from singulate.simulation.settling import settle
from singulate.simulation.world import World

POSES = (standing_pose(Block(0.0, 0.0)), standing_pose(Block(0.5, 0.5)))
SLIDING = (BlockMotion(POSES[0], (0.4, 0.0, 0.0)), BlockMotion(POSES[1]))


@pytest.fixture
def world() -> Iterator[World]:
    world = World(Workspace(), Physics())
    world.build(POSES)
    yield world
    world.close()


def come_to_rest(world: World, speeds: TopSpeeds) -> tuple[int, bool]:
    steps = settle(world, speeds, is_watched=False)
    while True:
        try:
            next(steps)
        except StopIteration as stop:
            num_steps, is_settled = stop.value
            return num_steps, is_settled


def test_a_block_slides_on_until_friction_has_stopped_it(world: World) -> None:
    world.set_motion(SLIDING)
    assert world.top_speeds() == fastest([(m.velocity, m.spin) for m in SLIDING])
    num_steps, is_settled = come_to_rest(world, world.top_speeds())
    assert is_settled
    assert num_steps >= 0.4 / world.physics.sliding_loss - 1
    sliding, resting = world.block_poses()
    stopping_distance = 0.4**2 / (2 * 0.6 * world.physics.gravity)
    assert sliding.position[0] == pytest.approx(stopping_distance, abs=0.003)
    assert math.dist(resting.position[:2], POSES[1].position[:2]) < 1e-5


def test_blocks_that_are_still_take_no_step(world: World) -> None:
    assert come_to_rest(world, world.top_speeds()) == (0, True)


def test_a_block_that_is_too_fast_means_that_the_physics_went_wrong(world: World) -> None:
    with pytest.raises(SimulationError, match="reached 11 m/s"):
        come_to_rest(world, TopSpeeds(11.0, 0.0))


def test_the_fastest_block_may_turn_slowest() -> None:
    slides, turns = ((3.0, 4.0, 0.0), (0.0, 0.0, 1.0)), ((1.0, 0.0, 0.0), (0.0, 2.0, 0.0))
    assert fastest([slides, turns]) == (5.0, 2.0)
    assert fastest([]) == (0.0, 0.0)
    assert math.isnan(fastest([slides, ((math.nan, 0.0, 0.0), (0.0, 0.0, 0.0))]).linear)
