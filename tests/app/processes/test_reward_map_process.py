import sys
from multiprocessing import Pipe

import numpy as np
import pytest

from app.processes.reward_map_messages import ComputeRewardMap
from app.processes.reward_map_process import run_reward_maps
from singulate.engine import EngineError
from singulate.geometry import Workspace, standing_pose
from singulate.simulation import make_scenario


@pytest.mark.timeout(30)
def test_it_ends_when_its_workers_cannot_start_so_that_it_is_restarted(monkeypatch):
    monkeypatch.setattr(sys, "executable", "/bin/false")
    layout = make_scenario("random-2").sample(np.random.default_rng(0), Workspace())
    ours, theirs = Pipe()
    with ours, theirs:
        ours.send(ComputeRewardMap(1, tuple(standing_pose(block) for block in layout)))
        with pytest.raises(EngineError, match="before they are ready"):
            run_reward_maps(theirs, 1)
        assert not ours.poll()
