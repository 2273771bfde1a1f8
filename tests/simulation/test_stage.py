"""The stage shows each scene as a new one would, whatever was on it before."""

import numpy as np
import pytest

from singulate.geometry import Workspace, standing_pose
from singulate.simulation import make_scenario
from singulate.simulation.camera import OverheadCamera
from singulate.simulation.stage import Stage

NAMES = ("fixed-2", "random-3", "cluster-10", "random-8", "cluster-4", "random-2")


def test_a_scene_looks_the_same_on_a_new_stage(capfd: pytest.CaptureFixture[str]) -> None:
    workspace, rng = Workspace(), np.random.default_rng(0)
    camera, used = OverheadCamera(workspace), Stage(workspace)
    for _ in range(60):
        layout = make_scenario(str(rng.choice(NAMES))).sample(rng, workspace)
        poses = tuple(map(standing_pose, layout))
        used.show(poses)
        fresh = Stage(workspace)
        fresh.show(poses)
        seen, expected = camera.photograph(used.client), camera.photograph(fresh.client)
        fresh.close()
        np.testing.assert_array_equal(seen.rgb, expected.rgb)
        np.testing.assert_array_equal(seen.depth, expected.depth)
    used.close()
    assert "Remove body failed" not in capfd.readouterr().out
