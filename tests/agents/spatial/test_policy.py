import time

import numpy as np
import pytest
import torch

from singulate.agents.policy import FloatMap, HasQMap
from singulate.agents.spatial.config import SpatialConfig
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.policy import SpatialPolicy, build_policy
from singulate.envs import EnvConfig, PushEnv
from singulate.geometry import Direction, Push, Workspace


@pytest.fixture
def policy(network: ValueNetwork) -> SpatialPolicy:
    policy = build_policy(SpatialConfig(net_arch=(8, 8)), EnvConfig("random-2"))
    policy.network.load_state_dict(network.state_dict())
    return policy


def test_a_turned_scene_is_pushed_the_same_way(policy: SpatialPolicy, image: FloatMap) -> None:
    push = policy.act(image)
    turned = policy.act(np.rot90(image))  # counter-clockwise
    assert turned.nearest_direction == Direction((push.nearest_direction - 1) % 4)
    assert turned.start == pytest.approx((-push.start[1], push.start[0]), abs=1e-5)


def test_starts_lie_on_no_grid(policy: SpatialPolicy, image: FloatMap) -> None:
    pixels = np.array(policy.act(image).start) * 32 - 0.5
    assert np.abs(pixels - np.rint(pixels)).max() > 0.01


def test_the_map_holds_the_values_of_its_pixels(policy: SpatialPolicy, image: FloatMap) -> None:
    assert isinstance(policy, HasQMap)
    values = policy.q_map(image)
    assert values.shape == (4, 64, 64)
    assert values.dtype == np.float32
    for direction, row, column in ((0, 40, 33), (1, 22, 5), (2, 0, 63), (3, 63, 0)):
        start = Workspace().row_col_to_xy(row, column)
        value = policy.predict_value(image, Push.cardinal(start, Direction(direction), 0.5))
        assert value == pytest.approx(values[direction, row, column], rel=1e-4)


def test_maps_of_all_directions_lie_as_the_table_does(
    pointwise: ValueNetwork, image: FloatMap
) -> None:
    policy = build_policy(SpatialConfig(net_arch=(16, 16)), EnvConfig("random-2"))
    policy.network.load_state_dict(pointwise.state_dict())
    expected = 6400.0 / (image.clip(min=0.0) + 6.4)
    assert np.allclose(policy.q_map(image), np.stack([expected] * 4), atol=1e-2)


def test_values_change_continuously_with_the_start(policy: SpatialPolicy, image: FloatMap) -> None:
    starts = np.linspace(-0.2, 0.2, 200)
    values = [policy.predict_value(image, Push((x, 0.0), (0.0, 1.0), 0.5)) for x in starts]
    assert np.ptp(values) > 0.0
    assert np.abs(np.diff(values)).max() < 0.2 * np.ptp(values)


def test_it_explores_with_a_generator(policy: SpatialPolicy, image: FloatMap) -> None:
    rng = np.random.default_rng(0)
    greedy = policy.act(image)
    others = sum(policy.act(image, rng) != greedy for _ in range(300))
    assert 3 <= others <= 35


def test_a_mask_is_worth_what_its_distance_map_is(
    policy: SpatialPolicy, network: ValueNetwork, image: FloatMap
) -> None:
    other = build_policy(SpatialConfig(net_arch=(8, 8)), EnvConfig(observation="mask"))
    other.network.load_state_dict(network.state_dict())
    assert other.act((image < 0.0).astype(np.float32)) == policy.act(image)


@pytest.mark.slow
@pytest.mark.parametrize("scenario", ["random-2", "random-3", "cluster-5"])
def test_acting_takes_less_than_5_ms_on_one_core(scenario: str, pace: float) -> None:
    policy = build_policy(SpatialConfig(), EnvConfig("random-2"))
    num_threads = torch.get_num_threads()
    torch.set_num_threads(1)
    env = PushEnv(scenario=scenario)
    times = []
    for seed in range(40):
        observation, _ = env.reset(seed=seed)
        began = time.process_time()
        policy.act(observation)
        times.append(time.process_time() - began)
    env.close()
    torch.set_num_threads(num_threads)
    assert np.median(times) < 5e-3 * pace
