"""Pushes of the environment against the clock."""

import functools
import time
from collections.abc import Callable

import numpy as np

from singulate.bench.turns import Stint, Turn
from singulate.envs.push_env import PushEnv
from singulate.geometry import Direction, Push


def make_env(scenario: str, exact: bool = False) -> Callable[[], PushEnv]:
    """A picklable factory of environments with continuous starts."""
    return functools.partial(PushEnv, scenario=scenario, action="point", exact=exact)


def push_at_random(env: PushEnv, turn: Turn) -> Stint:
    """Episodes of one uniformly random push each; most touch nothing."""
    return _push(env, turn, uniform_action)


def push_touching(env: PushEnv, turn: Turn) -> Stint:
    """Episodes of one push each, which always meets a block."""
    return _push(env, turn, touching_action)


def uniform_action(env: PushEnv, rng: np.random.Generator) -> object:
    """A uniformly random push of ``action="point"``."""
    return rng.uniform(-1.0, 1.0, 3).astype(np.float32)


def touching_action(env: PushEnv, rng: np.random.Generator) -> object:
    """A uniformly random action among those that touch a block and do not start on one."""
    workspace, scene = env.task.workspace, env.task.scene
    while True:
        action = rng.uniform(-1.0, 1.0, 3).astype(np.float32)
        x, y, c = (float(value) for value in action)
        direction = Direction(min(int((c + 1.0) * 2.0), 3))
        start = (x * workspace.half_length, y * workspace.half_length)
        push = Push.cardinal(start, direction, workspace.push_length)
        if scene.touches(push) and not scene.is_blocked(push):
            return action


def _push(
    env: PushEnv, turn: Turn, draw: Callable[[PushEnv, np.random.Generator], object]
) -> Stint:
    rng = np.random.default_rng(turn.seed)
    env.reset(seed=turn.seed)
    spent, num_pushes, num_steps = 0.0, 0, 0
    began = time.perf_counter()
    while not num_pushes or time.perf_counter() - began < turn.seconds:
        moments = [time.perf_counter()]
        env.reset()
        moments.append(time.perf_counter())
        action = draw(env, rng)
        moments.append(time.perf_counter())
        *_, info = env.step(action)
        moments.append(time.perf_counter())
        spent += moments[1] - moments[0] + moments[3] - moments[2]
        num_steps += info["outcome"].num_steps
        num_pushes += 1
    total = time.perf_counter() - began
    return Stint(num_pushes, spent, total, num_steps * env.task.scene.physics.time_step)
