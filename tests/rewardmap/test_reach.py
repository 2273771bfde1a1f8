import numpy as np
import pytest

from singulate.geometry import Direction, Poses, Push
from singulate.rewardmap.reach import blocked_starts, reaching_starts
from singulate.simulation import Scene

RESOLUTION = 32


@pytest.mark.parametrize("scene_name", ["row_poses", "pushed_poses"])
def test_grids_agree_with_the_scene(scene_name: str, request: pytest.FixtureRequest) -> None:
    poses: Poses = request.getfixturevalue(scene_name)
    with Scene() as scene:
        scene.restore(poses)
        workspace, side = scene.workspace, scene.physics.pusher_side
        blocked = blocked_starts(poses, workspace, RESOLUTION, side)
        reaching = reaching_starts(poses, workspace, RESOLUTION, side)
        for row, col in np.ndindex(RESOLUTION, RESOLUTION):
            start = workspace.row_col_to_xy(row, col, RESOLUTION)
            for direction in Direction:
                push = Push.cardinal(start, direction, workspace.push_length)
                assert scene.touches(push) == reaching[direction, row, col], push
            assert scene.is_blocked(push) == blocked[row, col], push
    assert blocked.any()
    assert 0.05 < reaching.mean() < 0.3


def test_a_block_on_the_floor_reaches_nothing(row_poses: Poses) -> None:
    fallen = tuple(pose._replace(position=(0.0, 0.0, -0.7)) for pose in row_poses)
    with Scene() as scene:
        assert not reaching_starts(fallen, scene.workspace, 8, 0.06).any()
        assert not blocked_starts(fallen, scene.workspace, 8, 0.06).any()
