"""``singulate/Push-v0`` as its users rely on it."""

import dataclasses

import gymnasium
import numpy as np
import pytest

import singulate.envs
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push
from singulate.rewards import make_reward
from singulate.simulation import Physics, Scene

ROW = [{"x": -0.1, "y": 0.0, "side": 0.2}, {"x": 0.1, "y": 0.0, "side": 0.2}]
FROM_BELOW = (0.1, -0.3)


def make(**settings):
    return gymnasium.make("singulate/Push-v0", **settings)


def point(x: float, y: float, direction: Direction) -> np.ndarray:
    return np.array([x, y, (direction + 0.5) / 2 - 1], dtype=np.float32)


def test_spaces_are_those_of_the_front_door():
    env = make(observation="distance_map", action="grid")
    assert env.action_space == gymnasium.spaces.Discrete(400)
    assert env.observation_space.shape == (64, 64)
    assert env.observation_space.dtype == np.float32
    assert make(action="point").action_space.shape == (3,)
    assert make(action="start_end").action_space.shape == (4,)
    env.close()


def test_one_good_push_singulates_two_blocks_and_is_paid_by_equation_7():
    env = make(scenario="random-2", action="point")
    _, info = env.reset(options={"blocks": ROW})
    assert info["num_segments"] == 1
    assert info["inter_object_distance"] == 0.0
    _, reward, terminated, truncated, info = env.step(point(*FROM_BELOW, Direction.UP))
    assert info["is_success"]
    assert terminated
    assert not truncated
    assert info["num_segments"] == 2
    terms = info["reward_terms"]
    assert terms["distance"] == pytest.approx(0.1)
    assert terms["success"] == 1.0
    assert terms["inside"] == 0.0
    assert 0.9 < terms["start"] <= 1.0
    assert reward == pytest.approx(300 * terms["start"] + 1000 * 0.1 + 1000)
    env.close()


def test_a_start_inside_a_block_is_punished_and_moves_nothing():
    env = make(scenario="random-2", action="point")
    before, _ = env.reset(options={"blocks": ROW})
    after, reward, terminated, _, info = env.step(point(0.1, 0.0, Direction.UP))
    assert info["reward_terms"] == {"start": 0.0, "distance": 0.0, "inside": 1.0, "success": 0.0}
    assert reward == -100.0
    assert terminated
    assert (before == after).all()
    env.close()


@pytest.mark.parametrize("name", ["paper", "separation", "start", "start_then_separation"])
def test_the_reward_is_the_weighted_sum_of_its_terms(name):
    env = make(scenario="fixed-2", action="point", reward=name)
    env.reset(seed=0)
    _, reward, _, _, info = env.step(point(*FROM_BELOW, Direction.UP))
    assert reward == make_reward(name).total(info["reward_terms"], 0)
    env.close()


def test_the_schedule_switches_after_forty_thousand_pushes():
    env = make(scenario="fixed-2", action="point", reward="start_then_separation")
    rewards = []
    for num_pushes in (39_999, 40_000):
        env.reset(seed=0)
        env.unwrapped.num_pushes = num_pushes
        rewards.append(env.step(point(*FROM_BELOW, Direction.UP))[1])
    assert rewards[0] == pytest.approx(300.0, abs=40)
    assert rewards[1] == pytest.approx(100.0, abs=1)
    env.close()


def test_several_pushes_make_an_episode_that_is_truncated_at_its_limit():
    env = make(scenario="cluster-3", action="point", max_pushes=3)
    env.reset(seed=0)
    ends = [env.step(point(0.95, 0.95, Direction.RIGHT))[2:4] for _ in range(3)]
    assert ends == [(False, False), (False, False), (False, True)]
    env.close()


def test_pushes_add_up_over_an_episode():
    env = make(scenario="random-2", action="point", max_pushes=4)
    env.reset(options={"blocks": ROW})
    _, _, terminated, _, info = env.step(point(0.1, -0.58, Direction.UP))
    assert not terminated
    assert info["outcome"].is_touching
    _, _, terminated, _, info = env.step(point(0.1, -0.3, Direction.UP))
    assert terminated
    assert info["is_success"]
    env.close()


def test_a_block_off_the_table_ends_the_episode_without_success():
    env = make(scenario="random-2", action="point", max_pushes=5)
    env.reset(options={"blocks": [{"x": 0.0, "y": 0.85}, {"x": 0.0, "y": 0.65}]})
    _, _, terminated, truncated, info = env.step(point(0.0, 0.3, Direction.UP))
    assert info["outcome"].fallen == (0,)
    assert terminated
    assert not truncated
    assert not info["is_success"]
    env.close()


def test_start_end_actions_push_along_their_own_line():
    env = make(scenario="random-2", action="start_end")
    env.reset(options={"blocks": ROW})
    _, _, _, _, info = env.step(np.array([0.1, -0.3, 0.1, 0.2], dtype=np.float32))
    push: Push = info["push"]
    assert push.length == pytest.approx(0.5)
    assert push.direction == pytest.approx((0.0, 1.0))
    assert info["is_success"]
    env.close()


def test_a_scene_that_starts_apart_is_a_success_from_the_start():
    env = make(scenario="random-2", action="point")
    _, info = env.reset(options={"blocks": [{"x": -0.4, "y": 0.0}, {"x": 0.4, "y": 0.0}]})
    assert info["is_success"]
    assert info["num_segments"] == 2
    env.close()


def test_rendering_shows_the_table():
    env = make(scenario="random-3", render_mode="rgb_array")
    env.reset(seed=1)
    picture = env.render()
    assert picture.shape == (360, 480, 3)
    assert picture.std() > 5
    env.close()


def test_the_mask_observation_is_the_mask():
    env = make(scenario="random-3", observation="mask")
    observation, info = env.reset(seed=4)
    assert (observation == info["mask"]).all()
    assert 0 < observation.sum() < 300
    env.close()


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"scenario": "pile-2"}, "scenario: 'pile-2'"),
        ({"observation": "rgb"}, "observation: 'rgb' is not allowed; allowed: distance_map, mask"),
        ({"action": "dance"}, "action: 'dance'"),
        ({"reward": "praise"}, "reward: 'praise'"),
        ({"max_pushes": 0}, "max_pushes: 0"),
        ({"max_pushes": 2.5}, "max_pushes: 2.5"),
        ({"goal_separation": float("nan")}, "goal_separation: nan"),
        ({"colour": "red"}, "environment setting: 'colour'"),
        ({"render_mode": "human"}, "render_mode: 'human'"),
    ],
)
def test_a_bad_setting_is_refused_in_one_line(settings, message):
    with pytest.raises(InvalidValueError) as error:
        singulate.envs.PushEnv(**settings)
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("blocks", "message"),
    [
        ([], "blocks: '0 blocks'"),
        ("two", "blocks: 'two'"),
        ([{"x": 0.0}], r"blocks[0].y"),
        ([{"x": 0.0, "y": 0.0, "mass": 1.0}], "blocks[0]: 'mass'"),
        ([{"x": float("nan"), "y": 0.0}], "blocks[0].x: nan"),
        ([{"x": "0", "y": 0.0}], "blocks[0].x: '0'"),
        ([{"x": 0.0, "y": 0.0, "side": 9.0}], "blocks[0].side: 9.0"),
        ([{"x": 0.95, "y": 0.0}], "blocks[0]: 'a block reaching to 1.050 m'"),
        ([{"x": 0.0, "y": 0.0}, {"x": 0.1, "y": 0.0}], "blocks[0], blocks[1]: 'an overlap"),
    ],
)
def test_a_bad_layout_is_refused_in_one_line(blocks, message):
    env = singulate.envs.PushEnv()
    with pytest.raises(InvalidValueError) as error:
        env.reset(options={"blocks": blocks})
    assert message in str(error.value)
    env.close()


@pytest.mark.parametrize(
    ("encoding", "action"),
    [
        ("grid", 400),
        ("grid", -1),
        ("grid", 1.5),
        ("point", [0.0, 0.0]),
        ("point", [0.0, 0.0, float("nan")]),
        ("point", [0.0, 2.0, 0.0]),
        ("start_end", "left"),
    ],
)
def test_a_bad_action_is_refused(encoding, action):
    env = singulate.envs.PushEnv(action=encoding)
    env.reset(seed=0)
    with pytest.raises(InvalidValueError, match="action"):
        env.step(action)
    env.close()


def test_physics_gone_wrong_truncates_the_episode_and_says_how():
    env = singulate.envs.PushEnv(scenario="random-2", max_pushes=3)
    env.task.scene.close()
    env.task.scene = Scene(physics=dataclasses.replace(Physics(), max_speed=1e-6))
    before, _ = env.reset(options={"blocks": ROW})
    after, reward, terminated, truncated, info = env.step(point(*FROM_BELOW, Direction.UP))
    assert (reward, terminated, truncated) == (0.0, False, True)
    assert "as before the push" in info["simulation_error"]
    assert not any(info["reward_terms"].values())
    assert info["poses"] == info["poses_before"]
    assert (before == after).all()
    env.close()


@pytest.mark.parametrize(
    ("action", "closest"),
    [
        ("grid", [Direction.RIGHT * 100 + 6 * 10 + 2]),
        ("point", [-0.52, -0.27, -0.25]),
        ("start_end", [-0.52, -0.27, -0.02, -0.27]),
    ],
)
def test_a_push_of_a_policy_becomes_the_closest_action(action, closest):
    env = singulate.envs.PushEnv(action=action)
    encoded = env.encode(Push.cardinal((-0.52, -0.27), Direction.RIGHT, 0.5))
    assert np.ravel(encoded) == pytest.approx(closest)
    assert env.action_space.contains(encoded)
    env.close()


def test_a_step_needs_a_scene_and_a_reset_only_known_options():
    env = singulate.envs.PushEnv()
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(point(*FROM_BELOW, Direction.UP))
    with pytest.raises(InvalidValueError, match="options: 'colour' is not allowed"):
        env.reset(options={"blocks": ROW, "colour": "red"})
    env.close()
