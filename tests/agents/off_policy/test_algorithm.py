from collections.abc import Callable
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
import torch
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.off_policy.algorithm import ActorCriticUpdates
from singulate.agents.registry import agent_kind

TARGET = np.array([0.4, -0.3, 0.1])
AGENTS = ("sac", "td3")

MakeModel = Callable[..., ActorCriticUpdates]


class OneTarget(gym.Env[np.ndarray, np.ndarray]):
    """One push an episode; the nearer it is to the target, the more it pays."""

    observation_space = gym.spaces.Box(-1.0, 91.0, (64, 64), np.float32)
    action_space = gym.spaces.Box(-1.0, 1.0, (3,), np.float32)

    def reset(self, *, seed: int | None = None, options: Any = None) -> tuple[np.ndarray, Any]:
        return np.full((64, 64), 8.0, np.float32), {}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        paid = 1.0 - float(np.square(action - TARGET).sum())
        return np.full((64, 64), 8.0, np.float32), paid, True, False, {}


@pytest.fixture
def make_model() -> MakeModel:
    def make(agent: str, num_envs: int = 1, **settings: Any) -> ActorCriticUpdates:
        kind = agent_kind(agent)
        small = {"net_arch": [32, 32], "batch_size": 32, "learning_starts": 64}
        config = kind.make_config(small | settings)
        envs = DummyVecEnv([OneTarget] * num_envs)
        model = kind.build_model(config, envs, "distance_map", 3)
        assert isinstance(model, ActorCriticUpdates)
        model.set_logger(Logger(folder=None, output_formats=[]))
        return model

    return make


@pytest.mark.parametrize("agent", AGENTS)
def test_it_finds_the_push_that_pays_most(agent: str, make_model: MakeModel) -> None:
    settings = {"net_arch": [16, 64, 64], "batch_size": 64, "gradient_steps": 2}
    model = make_model(agent, learning_rate=1e-3, learning_starts=128, **settings)
    model.learn(528)
    action, _ = model.predict(np.full((1, 64, 64), 8.0, np.float32), deterministic=True)
    assert np.abs(action[0] - TARGET).max() < 0.15
    assert model.predicted_values[0] == pytest.approx(1.0, abs=0.2)


@pytest.mark.parametrize("agent", AGENTS)
def test_first_pushes_are_uniform_and_later_ones_stay_in_the_box(
    agent: str, make_model: MakeModel
) -> None:
    model = make_model(agent, learning_starts=300)
    model.learn(300)
    buffer = model.replay_buffer
    assert buffer is not None
    first = buffer.actions[:300, 0]
    assert np.abs(first.mean(axis=0)).max() < 0.15
    assert np.allclose(first.std(axis=0), 2.0 / np.sqrt(12.0), atol=0.06)
    model.learn(40, reset_num_timesteps=False)
    assert np.abs(buffer.actions[300:340]).max() <= 1.0


@pytest.mark.parametrize("agent", AGENTS)
def test_exploration_does_not_depend_on_global_generators(
    agent: str, make_model: MakeModel
) -> None:
    tried = []
    for seed in (1, 2):
        model = make_model(agent, learning_starts=4)
        np.random.seed(seed)
        torch.manual_seed(seed)
        model.learn(5)
        assert model.replay_buffer is not None
        tried.append(model.replay_buffer.actions[:5].copy())
    assert np.array_equal(*tried)


def test_td3_tries_its_push_with_noise_of_the_given_width(make_model: MakeModel) -> None:
    model = make_model("td3", exploration_noise=0.05)
    observations = torch.full((2000, 64, 64), 8.0)
    with torch.no_grad():
        tried = model.explore(observations)
        centre = model.policy.actor(observations[:1]).numpy()
    assert np.allclose(tried.mean(axis=0), centre[0], atol=0.01)
    assert np.allclose(tried.std(axis=0), 0.05, atol=0.005)


def test_sac_tries_what_its_density_says(make_model: MakeModel) -> None:
    model = make_model("sac")
    observations = torch.full((2000, 64, 64), 8.0)
    with torch.no_grad():
        tried = np.arctanh(model.explore(observations))
        mean, log_std, _ = model.policy.actor.get_action_dist_params(observations[:1])
    assert np.allclose(tried.mean(axis=0), mean[0], atol=0.1)
    assert np.allclose(tried.std(axis=0), log_std[0].exp(), atol=0.1)


@pytest.mark.parametrize("agent", AGENTS)
def test_several_environments_make_as_many_updates_a_push(
    agent: str, make_model: MakeModel
) -> None:
    """Less those after the last push, which are left to whoever continues."""
    for num_envs in (1, 2):
        model = make_model(agent, num_envs, learning_starts=20, gradient_steps=2)
        model.learn(60)
        assert model._n_updates == 2 * (40 if num_envs == 1 else 38)
