import numpy as np
import pytest
import torch
from gymnasium import spaces
from stable_baselines3 import DQN
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import DummyVecEnv

from singulate.agents.dqn.config import DQNConfig
from singulate.agents.dqn.model import GridDQN, build_model, network_of
from singulate.agents.reward_scale import ScaledReward
from singulate.envs import PushEnv


def _model(max_grad_norm: float, share_of_last_pushes: float) -> GridDQN:
    env = PushEnv(scenario="random-2", action="grid")
    config = DQNConfig(net_arch=(32, 16), batch_size=8, buffer_size=64)
    model = build_model(config, DummyVecEnv([lambda: ScaledReward(env)]), "distance_map", seed=3)
    env.close()
    model.max_grad_norm = max_grad_norm
    rng = np.random.default_rng(1)
    assert isinstance(model.action_space, spaces.Discrete)
    assert model.replay_buffer is not None
    for _ in range(64):
        images = rng.uniform(-1, 40, (2, 1, 64, 64)).astype(np.float32)
        action, reward = rng.integers(0, 400, 1), rng.normal(0, 1, 1)
        done = np.array([rng.random() < share_of_last_pushes])
        model.replay_buffer.add(images[0], images[1], action, reward, done, [{}])
    return model


@pytest.mark.parametrize("max_grad_norm", [1e-3, 10.0])
@pytest.mark.parametrize("share_of_last_pushes", [0.3, 1.0])
def test_an_update_is_that_of_stable_baselines3_bit_for_bit(
    max_grad_norm: float, share_of_last_pushes: float
) -> None:
    ours = _model(max_grad_norm, share_of_last_pushes)
    theirs = _model(max_grad_norm, share_of_last_pushes)
    before = [parameter.clone() for parameter in ours.q_net.parameters()]
    for model in (ours, theirs):
        model.set_logger(_silent())
    ours.update(5)
    DQN.train(theirs, 5, batch_size=8)
    pairs = list(zip(ours.q_net.parameters(), theirs.q_net.parameters(), strict=True))
    assert all(torch.equal(one, other) for one, other in pairs)
    assert not any(torch.equal(one, new) for one, (new, _) in zip(before, pairs, strict=True))
    assert ours.logger.name_to_value["train/loss"] == theirs.logger.name_to_value["train/loss"]


def test_what_acts_after_training_is_the_running_average_of_the_network() -> None:
    tau = 0.25
    config = DQNConfig(
        net_arch=(8,), batch_size=4, buffer_size=64, learning_starts=4, gradient_steps=1,
        tau=tau, target_update_interval=1,
    )  # fmt: skip
    env = PushEnv(scenario="random-2", action="grid")
    model = build_model(config, DummyVecEnv([lambda: ScaledReward(env)]), "distance_map", seed=3)
    expected = _flat(model.q_net)

    def follow(*_: object) -> bool:
        nonlocal expected
        expected = expected + tau * (_flat(model.q_net) - expected)
        return True

    model.learn(12, callback=follow)
    env.close()
    assert torch.allclose(_flat(network_of(model)), expected, atol=1e-6)
    assert not torch.allclose(_flat(model.q_net), expected, atol=1e-4)


def test_the_step_size_falls_with_the_pushes_and_stays_low() -> None:
    config = DQNConfig(
        net_arch=(8,), batch_size=4, buffer_size=64, learning_starts=0,
        learning_rate=1e-3, final_learning_rate=1e-4, anneal_steps=10,
    )  # fmt: skip
    env = PushEnv(scenario="random-2", action="grid")
    model = build_model(config, DummyVecEnv([lambda: ScaledReward(env)]), "distance_map", seed=3)
    rates = []
    for pushes in (5, 10, 12):
        model.learn(pushes - model.num_timesteps, reset_num_timesteps=False)
        rates.append(model.policy.optimizer.param_groups[0]["lr"])
    env.close()
    assert rates == pytest.approx([5.5e-4, 1e-4, 1e-4])


def _flat(network: torch.nn.Module) -> torch.Tensor:
    return torch.nn.utils.parameters_to_vector(network.parameters()).detach().clone()


def _silent() -> Logger:
    return Logger(folder=None, output_formats=[])
