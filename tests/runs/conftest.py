from collections.abc import Callable
from pathlib import Path

import pytest

from singulate.geometry import Block, Push, standing_pose
from singulate.runs import PushRecord, RunDirectory

CONFIG = {"agent": "dqn", "env": {"scenario": "random-2"}, "total_timesteps": 100, "seed": 0}


@pytest.fixture
def run_dir(tmp_path: Path) -> Path:
    return RunDirectory(tmp_path / "run").create(CONFIG).path


@pytest.fixture
def make_push() -> Callable[..., PushRecord]:
    def make_push(step: int = 1, **changes: object) -> PushRecord:
        values: dict[str, object] = {
            "step": step,
            "episode": step,
            "push": Push((0.1 * (step % 7), -0.3), (0.6, 0.8), 0.5),
            "reward": 300.0 / 7.0,
            "terms": {"start": 1.0 / 3.0, "distance": -0.01, "inside": 0.0, "success": 0.0},
            "is_success": False,
            "outcome": "not_separated",
            "poses": (standing_pose(Block(0.1, 0.2, 0.2, 0.3)), standing_pose(Block(0.4, 0.2))),
            "predicted": 12.5,
        }
        return PushRecord(**{**values, **changes})  # type: ignore[arg-type]

    return make_push
