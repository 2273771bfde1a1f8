"""Where the time of a touching push goes."""

import cProfile
import time
from typing import NamedTuple

import numpy as np

from singulate.bench.pushes import touching_action
from singulate.bench.turns import Turn
from singulate.envs.push_env import PushEnv
from singulate.envs.push_task import PushTask
from singulate.geometry import CameraFrame, Push
from singulate.perception import Percept
from singulate.simulation import PushOutcome, Scene

_SOLVER = "pybullet.stepSimulation"


class PushParts(NamedTuple):
    """Mean times of a push with its reset [s].

    Attributes:
        total: All of it.
        physics: The push itself; the blocks' rest included.
        image: Taking pictures.
        perception: From a picture to the distance map and the separations.
        solver: Bullet's part of `physics`, at the share that it has under a profiler, which
            makes the Python around it slower.
        num_solver_steps: Steps that Bullet makes in it.
    """

    total: float
    physics: float
    image: float
    perception: float
    solver: float
    num_solver_steps: float


class TimedEnv(PushEnv):
    """Adds up the time [s] of its parts."""

    def __init__(self, scenario: str) -> None:
        super().__init__(scenario=scenario, action="point")
        self.task.close()
        self.timed_task = _TimedTask(goal_separation=self.config.goal_separation)
        self.task = self.timed_task


class _TimedScene(Scene):
    push_s = 0.0
    image_s = 0.0

    def push(self, push: Push) -> PushOutcome:
        began = time.perf_counter()
        try:
            return super().push(push)
        finally:
            self.push_s += time.perf_counter() - began

    def photograph_blocks(self) -> CameraFrame:
        began = time.perf_counter()
        frame = super().photograph_blocks()
        self.image_s += time.perf_counter() - began
        return frame


class _TimedTask(PushTask):
    perception_s = 0.0

    def __init__(self, goal_separation: float) -> None:
        super().__init__(goal_separation=goal_separation)
        self.scene.close()
        self.timed_scene = _TimedScene(self.workspace)
        self.scene = self.timed_scene

    @property
    def percept(self) -> Percept:
        began, image_s = time.perf_counter(), self.timed_scene.image_s
        percept = super().percept
        _ = percept.distance_map  # computed when it is first asked for, and the observation does
        image_s = self.timed_scene.image_s - image_s
        self.perception_s += time.perf_counter() - began - image_s
        return percept


def time_parts(env: TimedEnv, turn: Turn) -> PushParts:
    """Touching pushes for a while, then a fifth as many under a profiler."""
    rng = np.random.default_rng(turn.seed)
    env.reset(seed=turn.seed)
    task, scene = env.timed_task, env.timed_task.timed_scene
    scene.push_s = scene.image_s = task.perception_s = 0.0
    total, num_pushes = 0.0, 0
    while not num_pushes or total < turn.seconds:
        total += _episode(env, rng)
        num_pushes += 1
    spent = (scene.push_s, scene.image_s, task.perception_s)
    physics, image, perception = (each / num_pushes for each in spent)
    num_profiled = 1 + num_pushes // 5
    scene.push_s = 0.0
    profiler = cProfile.Profile()
    for _ in range(num_profiled):
        _episode(env, rng, profiler)
    calls, seconds = _solver(profiler)
    return PushParts(
        total=total / num_pushes,
        physics=physics,
        image=image,
        perception=perception,
        solver=physics * seconds / scene.push_s,
        num_solver_steps=calls / num_profiled,
    )


def _episode(
    env: PushEnv, rng: np.random.Generator, profiler: cProfile.Profile | None = None
) -> float:
    """Seconds that the environment takes for one episode."""
    began = time.perf_counter()
    env.reset()
    seconds = time.perf_counter() - began
    action = touching_action(env, rng)
    began = time.perf_counter()
    if profiler is None:
        env.step(action)
    else:
        profiler.runcall(env.step, action)
    return seconds + time.perf_counter() - began


def _solver(profiler: cProfile.Profile) -> tuple[int, float]:
    """Calls of Bullet's solver, and the time in them [s]."""
    found = [each for each in profiler.getstats() if _SOLVER in str(each.code)]
    return sum(each.callcount for each in found), sum(each.inlinetime for each in found)
