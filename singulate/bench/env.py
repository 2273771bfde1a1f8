"""Pushes per second of one environment on one core, and where the time goes."""

import time
from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np

from singulate.bench.measurement import BenchOptions, Measurement
from singulate.envs.push_env import PushEnv
from singulate.geometry import Direction, Push
from singulate.perception import perceive
from singulate.simulation import Scene, make_scenario

SCENARIO = "random-2"


def bench_env(options: BenchOptions) -> Iterator[Measurement]:
    """Time whole episodes of one push (reset and step) and the parts of a touching push."""
    env = PushEnv(scenario=SCENARIO, action="point")
    rng = np.random.default_rng(0)
    note = f"{SCENARIO}, reset and step, one process"
    try:
        uniform = _pushes_per_second(env, options.seconds, lambda: _uniform(rng))
        yield Measurement("uniformly random pushes", uniform, "pushes/s", note)
        touching = _pushes_per_second(env, options.seconds, lambda: _touching(env, rng))
        yield Measurement("touching pushes", touching, "pushes/s", note)
    finally:
        env.close()
    yield from _parts(options.seconds, rng)


def _pushes_per_second(env: PushEnv, seconds: float, draw: Callable[[], object]) -> float:
    """Rate of reset and step; drawing the action is not counted."""
    spent: float = 0.0
    num_pushes = 0
    while spent < seconds:
        began = time.perf_counter()
        env.reset(seed=num_pushes)
        spent += time.perf_counter() - began
        action = draw()
        began = time.perf_counter()
        env.step(action)
        spent += time.perf_counter() - began
        num_pushes += 1
    return num_pushes / spent


def _uniform(rng: np.random.Generator) -> object:
    return rng.uniform(-1.0, 1.0, 3).astype(np.float32)


def _touching(env: PushEnv, rng: np.random.Generator) -> object:
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


def _parts(seconds: float, rng: np.random.Generator) -> Iterator[Measurement]:
    """Mean time of each part of a touching push."""
    scenario = make_scenario(SCENARIO)
    spent = {"physics": 0.0, "image": 0.0, "perception": 0.0}
    num_pushes = 0
    with Scene() as scene:
        while sum(spent.values()) < seconds:
            scene.place(scenario.sample(rng, scene.workspace))
            push = _touching_push(scene, rng)
            moments = [time.perf_counter()]
            scene.push(push)
            moments.append(time.perf_counter())
            frame = scene.photograph()
            moments.append(time.perf_counter())
            perceive(frame, scene.workspace)
            moments.append(time.perf_counter())
            for part, (begin, end) in zip(spent, pairwise(moments), strict=True):
                spent[part] += end - begin
            num_pushes += 1
    total = sum(spent.values())
    for part, duration in spent.items():
        share = f"{duration / total:.0%} of a touching push"
        yield Measurement(part, 1e3 * duration / num_pushes, "ms", share)


def _touching_push(scene: Scene, rng: np.random.Generator) -> Push:
    half, length = scene.workspace.half_length, scene.workspace.push_length
    while True:
        start = (float(rng.uniform(-half, half)), float(rng.uniform(-half, half)))
        push = Push.cardinal(start, Direction(int(rng.integers(4))), length)
        if scene.touches(push) and not scene.is_blocked(push):
            return push
