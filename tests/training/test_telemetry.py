from pathlib import Path

import numpy as np

from singulate.envs import PushEnv
from singulate.runs import RunDirectory, RunReader
from singulate.training.telemetry import Telemetry


def test_a_push_that_the_physics_failed_at_is_recorded_as_such(tmp_path: Path) -> None:
    run_dir = RunDirectory(tmp_path / "run").create({}).path
    env = PushEnv(None, scenario="fixed-2")
    env.reset(seed=0)
    harmless = np.array([0.9, 0.9, 0.0], dtype=np.float32)
    info = env.step(harmless)[4] | {"episode_index": 0, "reward": 0.0}
    env.close()
    with Telemetry(run_dir) as telemetry:
        telemetry.add_push(1, info, None)
        telemetry.add_push(2, info | {"simulation_error": "a block flew away"}, None)
    reader = RunReader(run_dir)
    assert [push.outcome for push in reader.last_pushes(2)] == ["empty", "simulation_error"]
    (event,) = reader.events_since()
    assert event.kind == "simulation_error"
    assert event.detail == {"step": 2, "text": "a block flew away"}
