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
_MIN_PUSHES = 10


def bench_env(options: BenchOptions) -> Iterator[Measurement]:
    """Time whole episodes of one push (reset and step) and the parts of a touching push."""
    for kind, draw in {"uniformly random pushes": _uniform, "touching pushes": _touching}.items():
        fast, plain = _rates(options.seconds, draw)
        note = f"{SCENARIO}, reset and step, one process"
        yield Measurement(kind, fast, "pushes/s", note)
        yield Measurement(f"{kind}, plain", plain, "pushes/s", f"{note}, every step simulated")
        yield Measurement(f"{kind}, gain", fast / plain, "", "fast against plain, in turns")
    yield from _parts(options.seconds, np.random.default_rng(0))


def _rates(
    seconds: float, draw: Callable[[PushEnv, np.random.Generator], object]
) -> tuple[float, float]:
    """Pushes per second of the fast and of the plain environment, which take turns.

    A machine whose speed changes meanwhile then changes neither's lead.
    """
    envs = [PushEnv(scenario=SCENARIO, action="point", exact=exact) for exact in (False, True)]
    spent, num_pushes = [0.0, 0.0], 0
    rng = np.random.default_rng(0)
    while num_pushes < _MIN_PUSHES or sum(spent) < 2.0 * seconds:
        action: object = None
        for i, env in enumerate(envs):
            began = time.perf_counter()
            env.reset(seed=num_pushes)
            spent[i] += time.perf_counter() - began
            action = draw(env, rng) if action is None else action
            began = time.perf_counter()
            env.step(action)
            spent[i] += time.perf_counter() - began
        num_pushes += 1
    for env in envs:
        env.close()
    return num_pushes / spent[0], num_pushes / spent[1]


def _uniform(env: PushEnv, rng: np.random.Generator) -> object:
    return rng.uniform(-1.0, 1.0, env.action_space.shape).astype(np.float32)


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
            frame = scene.photograph_blocks()
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
