"""Table and pusher stay from scene to scene, and yet nothing is remembered."""

import dataclasses

import numpy as np
import pytest

from singulate.exceptions import SimulationError
from singulate.geometry import Direction, Poses, Push, Workspace, standing_pose
from singulate.simulation import Physics, Scene, make_scenario
from singulate.simulation.world import World

Job = tuple[Poses, Push]


def draw_jobs(num_jobs: int) -> list[Job]:
    """Pushes near blocks of scenes with other numbers and sides of blocks, some off the table."""
    rng = np.random.default_rng(3)
    jobs: list[Job] = []
    with Scene() as scene:
        while len(jobs) < num_jobs:
            name = ("random-2", "random-3", "cluster-5")[len(jobs) % 3]
            layout = make_scenario(name).sample(rng, scene.workspace)
            scene.place(layout)
            block = layout[int(rng.integers(len(layout)))]
            dx, dy = rng.uniform(-0.4, 0.4, 2)
            length = float(rng.choice([0.5, 1.2]))
            start = (block.x + float(dx), block.y + float(dy))
            push = Push.cardinal(start, Direction(int(rng.integers(4))), length)
            if scene.touches(push) and not scene.is_blocked(push):
                jobs.append((scene.poses, push))
    return jobs


def end(scene: Scene, job: Job) -> Poses:
    poses, push = job
    scene.restore(poses)
    scene.push(push)
    return scene.poses


def test_a_kept_world_gives_the_bits_of_a_new_one_in_any_order() -> None:
    jobs = draw_jobs(60)
    alone = []
    for job in jobs:
        with Scene() as scene:
            alone.append(end(scene, job))
    assert sum(any(pose.position[2] < 0.0 for pose in poses) for poses in alone) >= 3
    with Scene() as kept:
        for i in np.random.default_rng(0).permutation(2 * len(jobs)) % len(jobs):
            assert end(kept, jobs[i]) == alone[i]


def test_looking_at_a_scene_changes_no_push() -> None:
    jobs = draw_jobs(12)
    with Scene() as blind, Scene() as seeing:
        for i, job in enumerate(jobs):
            seeing.restore(jobs[i - 1][0])
            seeing.photograph_blocks()
            seeing.restore(tuple(pose._replace(position=(0.0, 0.0, 0.3)) for pose in job[0]))
            seeing.photograph_blocks()
            assert end(seeing, job) == end(blind, job)
            seeing.photograph_blocks()


def test_a_picture_shows_the_blocks_wherever_they_were_before() -> None:
    jobs = draw_jobs(12)
    with Scene() as kept:
        for poses, push in jobs:
            kept.restore(poses)
            before = kept.photograph_blocks().depth
            kept.push(push)
            after = kept.photograph_blocks().depth
            for shown, depth in ((poses, before), (kept.poses, after), (poses, before)):
                with Scene() as new:
                    new.restore(shown)
                    assert (new.photograph_blocks().depth == depth).all()
                kept.restore(shown)
                assert (kept.photograph_blocks().depth == depth).all()


def test_nothing_stays_once_the_physics_went_wrong(row, middle_push) -> None:
    poses = tuple(standing_pose(block) for block in row)
    with Scene() as sound:
        expected = end(sound, (poses, middle_push))
    physics = Physics()
    with Scene(Workspace(), physics) as scene:
        end(scene, (poses, middle_push))
        object.__setattr__(physics, "max_speed", 1e-6)
        with pytest.raises(SimulationError):
            end(scene, (poses, middle_push))
        object.__setattr__(physics, "max_speed", dataclasses.fields(Physics)[-1].default)
        assert end(scene, (poses, middle_push)) == expected


def test_the_simple_broadphase_finds_the_contacts_of_bullets_default_one() -> None:
    physics = Physics()
    for poses, push in draw_jobs(12):
        ends = []
        for is_kept in (True, False):
            world = World(Workspace(), physics, is_kept)
            world.build(poses)
            (x, y), (dx, dy) = push.start, push.direction
            world.place_pusher(x, y, physics.pusher_z, push.yaw)
            along = [0.004 * i for i in range(120)]
            for _ in world.drive_pusher(
                [(x + a * dx, y + a * dy, physics.pusher_z) for a in along]
            ):
                continue
            ends.append([pose.position for pose in world.block_poses()])
            world.close()
        assert np.abs(np.subtract(*ends)).max() < 1e-4


@pytest.mark.parametrize("num_steps", [1, 16, 20, 28])
def test_resting_in_one_call_gives_the_bits_of_as_many_steps(row, num_steps: int) -> None:
    moments = []
    for _ in range(2):
        world = World(Workspace(), Physics())
        world.build(tuple(standing_pose(block) for block in row))
        if moments:
            world.rest(num_steps)
        else:
            for _ in range(num_steps):
                world.step()
        moments.append(world.motion())
        world.step()  # of the usual length again
        moments.append(world.motion())
        world.close()
    assert moments[:2] == moments[2:]
    assert moments[0] != moments[1]
