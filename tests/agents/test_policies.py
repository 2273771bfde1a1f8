import numpy as np
import pytest

from singulate.agents.policy import HasQMap, HasStartDensity, Policy
from singulate.agents.random_policy import RandomPolicy
from singulate.agents.registry import AGENTS, agent_kind
from singulate.envs import EnvConfig, PushEnv
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push

CONFIGS = {name: EnvConfig("random-2", action=kind.actions[0]) for name, kind in AGENTS.items()}
CONFIGS |= {
    name: EnvConfig("random-2", observation="mask", action="point")
    for name in ("ppo", "td3", "fourier-ppo")
}


def _policy(name: str, **settings: object) -> Policy:
    kind = agent_kind(name)
    return kind.build_policy(kind.make_config(settings), CONFIGS[name])[0]


@pytest.mark.parametrize("name", CONFIGS)
def test_greedy_pushes_repeat_and_lie_in_the_workspace(name: str) -> None:
    env = PushEnv(None, **CONFIGS[name].to_dict())
    observation, _ = env.reset(seed=0)
    env.close()
    policy = _policy(name)
    push = policy.act(observation)
    assert push == policy.act(observation)
    assert max(abs(value) for value in push.start) <= 1.0
    assert push.length == 0.5
    assert isinstance(policy.predict_value(observation, push), float)


def test_dqn_pushes_where_its_q_map_is_highest() -> None:
    policy = _policy("dqn")
    assert isinstance(policy, HasQMap)
    observation = np.random.default_rng(1).uniform(0, 40, (64, 64)).astype(np.float32)
    values = policy.q_map(observation)
    assert values.shape == (4, 10, 10)
    assert values.dtype == np.float32
    direction, row, col = np.unravel_index(values.argmax(), values.shape)
    push = policy.act(observation)
    assert push.nearest_direction == Direction(direction)
    assert push.start == pytest.approx((-0.9 + 0.2 * col, 0.9 - 0.2 * row))
    assert policy.predict_value(observation, push) == pytest.approx(values.max())


def test_symmetric_values_turn_with_the_scene() -> None:
    policy = _policy("dqn", symmetric_values=True)
    assert isinstance(policy, HasQMap)
    scene = np.random.default_rng(1).uniform(0, 40, (64, 64)).astype(np.float32)
    values = policy.q_map(scene)
    turned = policy.q_map(np.rot90(scene))
    assert np.ptp(values) > 0
    up, left = Direction.UP, Direction.LEFT
    assert np.allclose(turned[left], np.rot90(values[up]), atol=1e-4)


def test_dqn_explores_with_a_generator() -> None:
    policy = _policy("dqn")
    observation = np.full((64, 64), 9.0, dtype=np.float32)
    rng = np.random.default_rng(0)
    pushes = {policy.act(observation, rng).start for _ in range(300)}
    assert 5 < len(pushes) < 60


@pytest.mark.parametrize("name", ["ppo", "trpo", "sac"])
def test_samples_follow_the_start_density(name: str) -> None:
    policy = _policy(name)
    assert policy.kind == name
    assert policy.is_random
    assert isinstance(policy, HasStartDensity)
    observation = np.zeros((64, 64), dtype=np.float32)
    density = policy.start_density(observation)
    assert density.shape == (64, 64)
    assert density.sum() == pytest.approx(1.0, abs=1e-4)
    rng = np.random.default_rng(0)
    starts = np.array([policy.act(observation, rng).start for _ in range(400)])
    assert abs((starts[:, 0] > 0).mean() - density[:, 32:].sum()) < 0.1
    assert abs((starts[:, 1] > 0).mean() - density[:32].sum()) < 0.1


def test_td3_makes_one_push_and_with_a_generator_others_around_it() -> None:
    policy = _policy("td3")
    assert not policy.is_random
    assert not isinstance(policy, HasStartDensity)
    observation = np.zeros((64, 64), dtype=np.float32)
    centre = np.array(policy.act(observation).start)
    rng = np.random.default_rng(0)
    starts = np.array([policy.act(observation, rng).start for _ in range(400)])
    assert starts.mean(axis=0) == pytest.approx(centre, abs=0.03)
    assert starts.std(axis=0) == pytest.approx([0.1, 0.1], abs=0.02)


@pytest.mark.parametrize("name", ["ppo", "trpo", "sac", "td3"])
def test_start_and_end_make_pushes_of_any_length(name: str) -> None:
    kind = agent_kind(name)
    env = EnvConfig("random-2", action="start_end")
    policy, _ = kind.build_policy(kind.make_config({}), env)
    observation = np.zeros((64, 64), dtype=np.float32)
    rng = np.random.default_rng(0)
    lengths = [policy.act(observation, rng).length for _ in range(20)]
    assert np.ptp(lengths) > 0.05
    assert isinstance(policy.predict_value(observation, policy.act(observation)), float)


def test_random_policy_is_uniform_and_needs_a_generator() -> None:
    policy = RandomPolicy()
    observation = np.zeros((64, 64), dtype=np.float32)
    rng = np.random.default_rng(0)
    pushes = [policy.act(observation, rng) for _ in range(400)]
    assert {push.nearest_direction for push in pushes} == set(Direction)
    assert abs(np.mean([push.start for push in pushes])) < 0.1
    assert policy.predict_value(observation, Push((0, 0), (1, 0), 0.5)) is None
    with pytest.raises(InvalidValueError, match="rng"):
        policy.act(observation)
