from collections.abc import Iterator

import numpy as np
import pytest

from singulate.engine import LocalEngine
from singulate.geometry import Direction, Poses, Push, Workspace, standing_pose
from singulate.simulation import Scene, make_scenario


@pytest.fixture(scope="session")
def engine() -> Iterator[LocalEngine]:
    with LocalEngine(num_workers=2) as engine:
        yield engine


@pytest.fixture(scope="session")
def row_poses() -> Poses:
    """Three blocks side by side, as ``random-3`` puts them for the seed 5."""
    layout = make_scenario("random-3").sample(np.random.default_rng(5), Workspace())
    return tuple(standing_pose(block) for block in layout)


@pytest.fixture(scope="session")
def pushed_poses(row_poses: Poses) -> Poses:
    """The same blocks, turned and moved by a push through an outer one's edge."""
    with Scene() as scene:
        scene.restore(row_poses)
        x, y, _ = row_poses[0].position
        outcome = scene.push(Push.cardinal((x + 0.09, y - 0.3), Direction.UP, 0.5))
        assert outcome.moved > 0.1
        return scene.poses
