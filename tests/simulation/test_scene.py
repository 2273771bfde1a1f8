"""Pushes on a real Bullet table."""

import dataclasses
import math
import multiprocessing
import pickle

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import Block, Direction, Poses, Push, Workspace
from singulate.simulation import Physics, PushOutcome, Scene, make_scenario


def positions(scene: Scene) -> np.ndarray:
    return np.array([pose.position for pose in scene.poses])


def push_in_fresh_scene(poses: Poses, push: Push) -> Poses:
    with Scene() as scene:
        scene.restore(poses)
        scene.push(push)
        return scene.poses


def random_contact_push(rng: np.random.Generator, poses: Poses) -> Push:
    x, y, _ = poses[rng.integers(len(poses))].position
    direction = Direction(int(rng.integers(4)))
    dx, dy = direction.vector
    aside = rng.uniform(-0.1, 0.1)
    return Push.cardinal((x - 0.3 * dx + aside * dy, y - 0.3 * dy + aside * dx), direction, 0.5)


def test_a_push_carries_the_middle_block_out_of_the_row(scene, row, middle_push):
    scene.place(row)
    outcome = scene.push(middle_push)
    left, middle, right = positions(scene)
    # The pusher's face ends at y = 0.2 + 0.03, so the block's centre at 0.33, and it slides a bit.
    assert middle[1] == pytest.approx(0.335, abs=0.015)
    assert abs(middle[0]) < 0.04
    assert left == pytest.approx((-0.2, 0.0, 0.1), abs=0.01)
    assert right == pytest.approx((0.2, 0.0, 0.1), abs=0.01)
    assert outcome.is_touching
    assert outcome.is_settled
    assert outcome.moved == pytest.approx(middle[1], abs=0.005)


def test_blocks_slide_on_by_less_than_half_a_pixel(scene, middle_push):
    scene.place((Block(0.0, 0.0),))
    scene.push(middle_push)
    slide = positions(scene)[0][1] - 0.33
    assert 0.0 < slide < Workspace().metres_per_pixel / 2


def test_a_push_past_the_blocks_moves_nothing_and_costs_nothing(scene, row):
    scene.place(row)
    before = scene.poses
    assert scene.push(Push.cardinal((0.8, -0.8), Direction.LEFT, 0.5)) == PushOutcome()
    assert scene.poses == before


def test_a_start_with_the_footprint_on_a_block_is_not_simulated(scene, row):
    scene.place(row)
    before = scene.poses
    outcome = scene.push(Push.cardinal((0.0, -0.12), Direction.UP, 0.5))
    assert outcome.is_blocked
    assert outcome.num_steps == 0
    assert scene.poses == before
    assert not scene.push(Push.cardinal((0.0, -0.135), Direction.UP, 0.5)).is_blocked


def test_the_outcome_does_not_depend_on_what_was_simulated_before(scene):
    rng = np.random.default_rng(0)
    scenario = make_scenario("random-3")
    for _ in range(25):
        scene.place(scenario.sample(rng, scene.workspace))
        start = scene.poses
        push = random_contact_push(rng, start)
        scene.push(push)
        assert scene.poses == push_in_fresh_scene(start, push)
        scene.push(random_contact_push(rng, scene.poses))


def test_another_process_gets_the_same_bits(scene, row, middle_push):
    scene.place(row)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        elsewhere = pool.apply(push_in_fresh_scene, (scene.poses, middle_push))
    scene.push(middle_push)
    assert elsewhere == scene.poses


def test_watching_a_push_step_by_step_gives_the_same_outcome(scene, row, middle_push):
    scene.place(row)
    start = scene.poses
    outcome = scene.push(middle_push)
    end = scene.poses
    scene.restore(start)
    steps = scene.push_steps(middle_push)
    frames = []
    while True:
        try:
            frames.append(next(steps))
        except StopIteration as stop:
            assert stop.value == outcome
            break
        assert scene.poses == start
    assert scene.poses == end
    assert len(frames) == outcome.num_steps
    path = np.array([frame.pusher[1] for frame in frames])
    assert path[0] == pytest.approx(-0.296, abs=1e-3)
    assert path.max() == pytest.approx(0.2, abs=2e-3)


def test_an_abandoned_push_leaves_the_scene_as_it_was(scene, row, middle_push):
    scene.place(row)
    start = scene.poses
    steps = scene.push_steps(middle_push)
    for _ in range(100):
        next(steps)
    steps.close()
    assert scene.poses == start
    scene.push(middle_push)
    assert scene.poses == push_in_fresh_scene(start, middle_push)


def test_a_block_pushed_over_the_edge_lies_on_the_floor_and_stays_there(scene):
    scene.place((Block(0.0, 0.85), Block(-0.5, -0.5)))
    outcome = scene.push(Push.cardinal((0.0, 0.65), Direction.UP, 0.5))
    assert outcome.fallen == (0,)
    fallen, standing = scene.poses
    assert fallen.position[2] == pytest.approx(-0.75 + 0.1)
    assert standing.position == pytest.approx((-0.5, -0.5, 0.1), abs=1e-3)
    again = scene.push(Push.cardinal((-0.5, -0.8), Direction.UP, 0.5))
    assert again.fallen == ()
    assert scene.poses[0] == fallen


def test_poses_survive_pickling_and_restoring(scene, row, middle_push):
    scene.place(row)
    scene.push(middle_push)
    end = scene.poses
    scene.place(row)
    scene.restore(pickle.loads(pickle.dumps(end)))
    assert scene.poses == end


def test_poses_that_are_not_finite_are_refused(scene, row):
    scene.place(row)
    bad = scene.poses[0]._replace(position=(math.nan, 0.0, 0.1))
    with pytest.raises(InvalidValueError, match=r"poses\[0\]"):
        scene.restore((bad,))
    assert len(scene.poses) == 3


def test_physics_gone_wrong_is_reported_and_undone(row, middle_push):
    reckless = dataclasses.replace(Physics(), max_speed=1e-6)
    with Scene(physics=reckless) as scene:
        scene.place(row)
        before = scene.poses
        with pytest.raises(SimulationError, match="as before the push"):
            scene.push(middle_push)
        assert scene.poses == before


def test_an_oblique_push_follows_its_line(scene):
    scene.place((Block(0.0, 0.0, 0.2, math.pi / 4),))
    scene.push(Push.between((-0.3, -0.3), (0.1, 0.1)))
    x, y, _ = positions(scene)[0]
    assert x == pytest.approx(y, abs=0.01)
    assert x == pytest.approx(0.1 + 0.13 / math.sqrt(2), abs=0.02)
