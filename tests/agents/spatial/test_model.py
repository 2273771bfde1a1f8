from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.loading import load_policy
from singulate.agents.reward_scale import ScaledReward
from singulate.agents.spatial.choice import best_push
from singulate.agents.spatial.config import SpatialConfig
from singulate.agents.spatial.model import SpatialModel, build_model, learning_rate_at, network_of
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.window import read_between
from singulate.envs import EnvConfig, PointActions, PushEnv
from singulate.evaluation import evaluate
from singulate.geometry import Workspace
from singulate.training.config import TrainingConfig
from singulate.training.trainer import train


@pytest.fixture
def make_model() -> Iterator[Any]:
    envs = []

    def make(**settings: Any) -> SpatialModel:
        envs.append(PushEnv(scenario="random-2", action="point"))
        config = SpatialConfig(**{"net_arch": (8, 8), "batch_size": 32, **settings})
        steps = DummyVecEnv([lambda: ScaledReward(envs[-1])])
        model = build_model(config, steps, "distance_map", seed=3)
        model.set_logger(Logger(folder=None, output_formats=[]))
        return model

    yield make
    for env in envs:
        env.close()


def test_updates_lower_the_loss_on_what_was_seen(make_model: Any) -> None:
    model = make_model(learning_starts=40, learning_rate=3e-3)
    model.learn(40)
    losses = []
    for _ in range(20):
        model.update(10)
        losses.append(model.logger.name_to_value["train/loss"])
    assert np.mean(losses[-3:]) < 0.5 * np.mean(losses[:3])


def test_the_average_follows_the_weights_that_learn(make_model: Any) -> None:
    model = make_model(learning_starts=20, average_decay=0.5)
    model.learn(20)
    pairs = list(
        zip(model.policy.learning.parameters(), network_of(model).parameters(), strict=True)
    )
    before = [averaged.clone() for _, averaged in pairs]
    model.update(1)
    for old, (learnt, averaged) in zip(before, pairs, strict=True):
        assert torch.allclose(averaged, (old + learnt) / 2, atol=1e-7)
        assert not torch.equal(averaged, old)


def test_the_value_of_an_executed_push_is_predicted(
    make_model: Any, pointwise: ValueNetwork
) -> None:
    model = make_model(net_arch=(16, 16), learning_starts=1000)
    model.learn(1)
    network_of(model).load_state_dict(pointwise.state_dict())
    values = torch.from_numpy(6.4 / (model._last_obs.clip(min=0.0) + 6.4))
    directions = set()
    for _ in range(20):
        (action,), _ = model._sample_action(1000)
        push = PointActions(Workspace()).decode(action)
        x, y = np.clip(push.start, -63 / 64, 63 / 64)
        pixel = torch.tensor([[(1.0 - y) * 32 - 0.5, (x + 1.0) * 32 - 0.5]], dtype=torch.float32)
        assert model.predicted_values == pytest.approx(read_between(values, pixel), abs=1e-4)
        directions.add(push.nearest_direction)
    assert len(directions) >= 3


def test_without_exploration_it_pushes_near_its_best_start(make_model: Any) -> None:
    model = make_model(
        learning_starts=1, exploration_steps=1, exploration_final_eps=0.0, start_noise=0.01
    )
    model.learn(4)
    best = best_push(network_of(model), model._last_obs[0], Workspace())
    expected, _ = model.policy.predict(model._last_obs)
    assert np.allclose(expected[0], PointActions(Workspace()).encode(best), atol=1e-6)
    starts = np.array([model._sample_action(1)[0][0, :2] for _ in range(30)])
    assert 0.0 < starts.std(axis=0).max() < 0.03


def test_the_learning_rate_falls_with_the_pushes_alone() -> None:
    config = SpatialConfig(learning_rate=1e-2, learning_rate_decay=100)
    assert learning_rate_at(0, config) == 1e-2
    assert learning_rate_at(100, config) == pytest.approx(1e-2 / 2**0.5)
    assert learning_rate_at(9900, config) == pytest.approx(1e-3)


def test_it_learns_random_2_from_300_pushes(tmp_path: Path) -> None:
    """Random aimed pushes succeed in about one scene of eight."""
    env = EnvConfig("random-2")
    result = train(TrainingConfig("spatial", env, 300, seed=1), tmp_path / "run")
    found = evaluate(load_policy(result.run_dir), env, 60, seed=99)
    assert found.success_rate > 0.7


@pytest.mark.slow
def test_one_set_of_weights_solves_rows_of_two_and_three(tmp_path: Path) -> None:
    config = TrainingConfig("spatial", EnvConfig("random-2+random-3"), 3000, seed=0)
    policy = load_policy(train(config, tmp_path / "run").run_dir)
    for scenario in ("random-2", "random-3"):
        assert evaluate(policy, EnvConfig(scenario), 500, seed=99).success_rate >= 0.98
