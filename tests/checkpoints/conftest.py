from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from singulate.checkpoints import Manifest, save_checkpoint

Save = Callable[..., Path]


@pytest.fixture
def save(tmp_path: Path) -> Save:
    def save(name: str = "step-000000100", step: int = 100, value: float = 1.5) -> Path:
        tensors = {
            "layer.weight": np.full((4, 3), value, np.float32),
            "layer.bias": np.arange(3, dtype=np.float32),
            "count": np.array(step, np.int64),
        }
        manifest = Manifest(
            agent="dqn",
            agent_config={"learning_rate": 5e-4, "net_arch": [128, 64]},
            env_config={"scenario": "random-2"},
            step=step,
            notes={"seed": 0},
        )
        files = {"training_state.json": b'{"num_updates": 3}', "README.md": b"# A DQN\n"}
        return save_checkpoint(tmp_path / name, tensors, manifest, files)

    return save
