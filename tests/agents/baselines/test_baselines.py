from collections.abc import Iterator

import numpy as np
import pytest

from singulate import load_policy
from singulate.agents.baselines import BASELINES
from singulate.agents.baselines.geometric import GeometricPolicy
from singulate.agents.baselines.random_contact import RandomContactPolicy
from singulate.agents.policy import Policy
from singulate.envs import EnvConfig, PushEnv
from singulate.evaluation import evaluate
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push


@pytest.fixture(scope="module")
def env() -> Iterator[PushEnv]:
    table = PushEnv(None, scenario="random-2")
    yield table
    table.close()


@pytest.mark.parametrize("name", BASELINES)
def test_a_name_loads_what_a_checkpoint_would(name: str, env: PushEnv) -> None:
    policy = load_policy(name)
    assert isinstance(policy, Policy)
    assert policy.kind == name
    observation, _ = env.reset(seed=1)
    push = policy.act(observation, np.random.default_rng(0))
    assert push == load_policy(name).act(observation, np.random.default_rng(0))
    assert max(map(abs, push.start)) <= 1.0
    assert (push.length, policy.predict_value(observation, push)) == (0.5, None)


@pytest.mark.parametrize("kind", ["distance_map", "mask"])
def test_random_contacts_touch_a_block_and_start_beside_it(kind: str) -> None:
    env = PushEnv(None, scenario="random-2", observation=kind)
    policy, rng = RandomContactPolicy(kind), np.random.default_rng(0)
    pushes = []
    for seed in range(40):
        observation, _ = env.reset(seed=seed)
        push = policy.act(observation, rng)
        assert not env.task.scene.is_blocked(push)
        pushes.append((env.task.scene.touches(push), push.nearest_direction))
    env.close()
    assert np.mean([touches for touches, _ in pushes]) >= 0.9  # pixels are coarser than blocks
    assert {direction for _, direction in pushes} == set(Direction)


def test_random_contacts_are_uniform_over_the_pushes_that_hit() -> None:
    distance_map = np.full((64, 64), 5.0, np.float32)
    distance_map[30:34, 30:34] = -1.0  # 0.125 m around the origin
    policy, rng = RandomContactPolicy(), np.random.default_rng(1)
    starts = np.array([policy.act(distance_map, rng).start for _ in range(400)])
    reach = 0.0625 + 0.03 + 0.5
    assert np.abs(starts).max() <= reach
    assert np.abs(starts).max() > reach - 0.03
    assert np.abs(starts.mean(axis=0)).max() < 0.06


def test_an_empty_table_is_pushed_anyhow() -> None:
    empty = np.full((64, 64), 90.0, np.float32)
    assert RandomContactPolicy().act(empty, np.random.default_rng(0)).length == 0.5
    assert GeometricPolicy().act(empty).length == 0.5


def test_random_contact_needs_a_generator() -> None:
    with pytest.raises(InvalidValueError, match="rng"):
        RandomContactPolicy().act(np.zeros((64, 64), np.float32))


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (0.5, 0.0), (0.0, -0.5)])
def test_geometric_shears_the_middle_block_out_of_three(x: float, y: float, env: PushEnv) -> None:
    blocks = [{"x": x + dx, "y": y, "side": 0.2, "yaw": 0.0} for dx in (-0.2, 0.0, 0.2)]
    observation, _ = env.reset(options={"blocks": blocks})
    push = GeometricPolicy().act(observation)
    assert push.nearest_direction in (Direction.UP, Direction.DOWN)
    assert push.start[0] == pytest.approx(x, abs=0.04)
    assert abs(push.end[1]) <= 0.55
    assert env.task.execute(push).is_success


def test_geometric_ignores_the_generator(env: PushEnv) -> None:
    observation, _ = env.reset(seed=3)
    policy = GeometricPolicy()
    assert policy.act(observation) == policy.act(observation, np.random.default_rng(0))


def test_each_baseline_is_better_than_the_one_before() -> None:
    config = EnvConfig("random-2")
    rates = [evaluate(BASELINES[name](), config, 60, seed=4).success_rate for name in BASELINES]
    assert list(BASELINES) == ["random", "random-contact", "geometric"]
    assert rates[0] < rates[1] < rates[2]
    assert rates[2] >= 0.9


def test_geometric_does_not_go_by_the_kind_of_observation() -> None:
    pushes: list[Push] = []
    for kind in ("distance_map", "mask"):
        env = PushEnv(None, scenario="random-3", observation=kind)
        pushes.append(GeometricPolicy(kind).act(env.reset(seed=9)[0]))
        env.close()
    assert pushes[0] == pushes[1]
