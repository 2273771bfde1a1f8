from typing import Any

import pytest

from singulate.envs import EnvConfig
from singulate.training.config import TrainingConfig


@pytest.fixture
def make_config() -> Any:
    """Small, fast runs of every agent."""

    def make(agent: str, total_timesteps: int, **changes: Any) -> TrainingConfig:
        if agent == "dqn":
            env = EnvConfig("cluster-3", action="grid")
            settings = {
                "learning_starts": changes.pop("learning_starts", 10),
                "batch_size": 8,
                "exploration_steps": 60,
            }
        elif agent == "spatial":
            env = EnvConfig("cluster-3", action="point")
            settings = {"learning_starts": 10, "batch_size": 8, "exploration_steps": 60}
        elif agent in ("sac", "td3"):
            env = EnvConfig("cluster-3", action="point")
            settings = {"learning_starts": 10, "batch_size": 8}
        else:
            env = EnvConfig("fixed-2", action="point")
            settings = {"n_steps": 16, "batch_size": 4}
        return TrainingConfig(
            agent, env, total_timesteps, agent_config=settings | {"net_arch": [16, 8]}, **changes
        )

    return make
