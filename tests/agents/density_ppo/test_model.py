from typing import Any

import gymnasium as gym
import numpy as np
import pytest
import torch
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.density_ppo.model import DensityPPO
from singulate.agents.registry import agent_kind

SMALL = {"net_arch": (8, 8), "n_steps": 128, "batch_size": 32}
AGENTS: dict[str, dict[str, object]] = {
    "multimodal-ppo": {"num_cells": 8},
    "mixture-ppo": {"num_components": 8},
    "fourier-ppo": {"num_cells": 16, "num_frequencies": 8},
}
"""Their settings, smaller than usual."""

SIDES = ((-0.5, 0.1, 0), (0.6, -0.3, 3))
"""Two pushes, x / l, y / l and direction, that pay alike."""
CHANCE = 0.25 / 4 / 4
"""Share of uniformly random pushes that one of them gets: a quarter of each axis, a direction."""


class TwoTargets(gym.Env[np.ndarray, np.ndarray]):
    """One push an episode; it pays near either of two very different pushes."""

    observation_space = gym.spaces.Box(-1.0, 91.0, (64, 64), np.float32)
    action_space = gym.spaces.Box(-1.0, 1.0, (3,), np.float32)

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[np.ndarray, Any]:
        rows, cols = np.mgrid[0:64, 0:64]
        self._seen = np.hypot(rows - 20.0, cols - 40.0).astype(np.float32)
        return self._seen, {}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        x, y, c = (float(value) for value in action)
        direction = min(int((c + 1) * 2), 3)
        pays = [
            direction == side[2] and max(abs(x - side[0]), abs(y - side[1])) < 0.25
            for side in SIDES
        ]
        return self._seen, float(any(pays)), True, False, {}


def make_model(agent: str, **settings: object) -> DensityPPO:
    kind = agent_kind(agent)
    config = kind.make_config(SMALL | AGENTS[agent] | settings)
    model = kind.build_model(config, DummyVecEnv([TwoTargets]), "distance_map", seed=0)
    assert isinstance(model, DensityPPO)
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model


@pytest.mark.parametrize(
    ("agent", "num_pushes", "ent_coef", "final_ent_coef"),
    [
        ("multimodal-ppo", 4500, 0.6, 0.3),
        ("mixture-ppo", 3000, 0.05, 0.01),
        ("fourier-ppo", 3000, 0.05, 0.01),
    ],
)
def test_it_learns_both_of_two_pushes_that_pay(
    agent: str, num_pushes: int, ent_coef: float, final_ent_coef: float
) -> None:
    """A Gaussian could cover one of them, or the useless middle.

    The entropy of Gaussians also grows beyond the table, so its bonus has to be small.
    """
    schedule = {"anneal_steps": num_pushes, "ent_coef": ent_coef, "final_ent_coef": final_ent_coef}
    model = make_model(agent, learning_rate=3e-3, **schedule)
    model.learn(num_pushes)
    observation = torch.as_tensor(model.get_env().reset())  # type: ignore[union-attr]
    distribution = model.policy.get_distribution(observation.expand(2000, -1, -1))
    pushes = distribution.sample()
    direction = ((pushes[:, 2] + 1) * 2).long().clamp(0, 3)
    shares = []
    for x, y, side in SIDES:
        near = (pushes[:, :2] - torch.tensor([x, y])).abs().amax(dim=1) < 0.25
        shares.append(float((near & (direction == side)).float().mean()))
    assert min(shares) > 10 * CHANCE, "one of them is lost"
    assert sum(shares) > 0.5, "most pushes still miss both"


def test_schedules_depend_on_the_pushes_alone() -> None:
    settings = {
        "learning_rate": 1e-3, "final_learning_rate": 1e-4,
        "ent_coef": 0.02, "final_ent_coef": 0.01, "anneal_steps": 256,
    }  # fmt: skip
    model = make_model("multimodal-ppo", **settings)
    model.learn(128)
    assert model.logger.name_to_value["train/learning_rate"] == pytest.approx(5.5e-4)
    assert model.ent_coef == pytest.approx(0.015)
    model.learn(384, reset_num_timesteps=False)
    assert model.policy.optimizer.param_groups[0]["lr"] == pytest.approx(1e-4)
    assert model.ent_coef == pytest.approx(0.01)


@pytest.mark.parametrize("agent", AGENTS)
def test_rollouts_hold_the_densities_that_an_update_starts_from(agent: str) -> None:
    """So the first ratio of new to old density is one, as PPO requires."""
    settings = {"n_epochs": 1, "batch_size": 128, "final_learning_rate": 0.0}
    model = make_model(agent, learning_rate=1e-9, **settings)
    model.learn(128)
    buffer = model.rollout_buffer
    batch = next(buffer.get(128))
    _, log_prob, _ = model.policy.evaluate_actions(batch.observations, batch.actions)
    assert torch.allclose(log_prob, batch.old_log_prob, atol=2e-3)
