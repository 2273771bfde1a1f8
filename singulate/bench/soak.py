"""Resident memory of one process over many pushes and many reward maps."""

import functools
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import msgspec
import numpy as np

from singulate.bench.machine import describe_machine
from singulate.bench.maps import make_poses
from singulate.bench.memory import own_memory, workers_memory
from singulate.bench.pushes import make_env, touching_action, uniform_action
from singulate.bench.results import decode_file
from singulate.engine import EngineError, LocalEngine
from singulate.envs.push_env import PushEnv
from singulate.exceptions import InvalidValueError
from singulate.rewardmap import RewardMapRequest, compute_reward_map

SCENARIO = "random-3"
NUM_PARTS = 10
_PUSHES_PER_TASK = 100

OnProgress = Callable[[int], None]
"""Told how many more have been done."""


@dataclass(frozen=True)
class SoakOptions:
    """How much to do.

    Attributes:
        num_pushes: Pushes, at least 10.
        num_maps: Reward maps, at least 10.
        hit_share: Part of the pushes that is drawn so that they meet a block; the others are
            uniformly random, and most of them touch nothing.
        resolution: Starts along each side of a map.

    Raises:
        InvalidValueError: If a value is out of range.
    """

    num_pushes: int = 100_000
    num_maps: int = 1_000
    hit_share: float = 0.1
    resolution: int = 64

    def __post_init__(self) -> None:
        for key, value in {"pushes": self.num_pushes, "maps": self.num_maps}.items():
            if not NUM_PARTS <= value <= 10**9:
                raise InvalidValueError(key, value, f"{NUM_PARTS} to 1000000000")
        if not 0.0 <= self.hit_share <= 1.0:
            raise InvalidValueError("hits", self.hit_share, "0 to 1")
        RewardMapRequest((), self.resolution)


@dataclass(frozen=True)
class SoakedMemory:
    """Resident memory after each tenth of the work.

    Attributes:
        what: What was done.
        num_done: How many of them, after each tenth.
        worker_mib: Of the process that simulated them all [MiB].
        parent_mib: Of the process that asked it to [MiB].
        growth_mib: What the worker held after the last tenth more than after the first [MiB].
        seconds: Time that all of it took [s].
    """

    what: str
    num_done: list[int]
    worker_mib: list[float]
    parent_mib: list[float]
    growth_mib: float
    seconds: float


@dataclass(frozen=True)
class SoakResults:
    """A soak and the machine that it ran on."""

    machine: dict[str, str | int | float]
    pushes: SoakedMemory
    reward_maps: SoakedMemory

    def to_json(self) -> str:
        """Indented, so that a committed file shows what changed."""
        return msgspec.json.format(msgspec.json.encode(self), indent=2).decode()


class _Pushes(NamedTuple):
    num_pushes: int
    hit_share: float
    seed: int


def soak(
    options: SoakOptions,
    on_push: OnProgress = lambda count: None,
    on_map: OnProgress = lambda count: None,
) -> SoakResults:
    """Let one worker process simulate all pushes, then all maps.

    Raises:
        EngineError: If the worker had to be replaced, so that its memory says nothing.
    """
    pushes = functools.partial(_push, hit_share=options.hit_share, on_progress=on_push)
    maps = functools.partial(_map, resolution=options.resolution, on_progress=on_map)
    side = options.resolution
    with LocalEngine(1, niceness=0) as engine:
        kind = f"pushes on {SCENARIO}, {options.hit_share:.0%} drawn to hit, the rest at random"
        over_pushes = _soak(engine, pushes, options.num_pushes, kind)
        kind = f"reward maps of {SCENARIO}, {side} x {side}"
        over_maps = _soak(engine, maps, options.num_maps, kind)
    return SoakResults(describe_machine(), over_pushes, over_maps)


def read_soak(path: Path) -> SoakResults:
    """Read a file that `singulate soak` wrote.

    Raises:
        InvalidValueError: If it is no such file.
        OSError: If it cannot be read.
    """
    return decode_file(path, SoakResults, "soak", "singulate soak --json")


def _soak(
    engine: LocalEngine, work: Callable[[LocalEngine, int, int], None], total: int, what: str
) -> SoakedMemory:
    ends = [total * (i + 1) // NUM_PARTS for i in range(NUM_PARTS)]
    worker, parent, pids = [], [], set()
    began = time.monotonic()
    for begin, end in zip([0, *ends], ends, strict=False):
        work(engine, begin, end)
        (memory,) = workers_memory(engine)
        pids.add(memory.pid)
        if len(pids) > 1:
            raise EngineError("the worker ended and was replaced; its memory says nothing")
        worker.append(round(memory.resident_bytes / 2**20, 2))
        parent.append(round(own_memory().resident_bytes / 2**20, 2))
    growth = round(worker[-1] - worker[0], 2)
    seconds = round(time.monotonic() - began, 1)
    return SoakedMemory(what, ends, worker, parent, growth, seconds)


def _push(
    engine: LocalEngine, begin: int, end: int, hit_share: float, on_progress: OnProgress
) -> None:
    tasks = [
        _Pushes(min(_PUSHES_PER_TASK, end - first), hit_share, seed=first)
        for first in range(begin, end, _PUSHES_PER_TASK)
    ]
    for result in engine.submit(_push_some, tasks, make_env(SCENARIO)):
        on_progress(result.value)


def _push_some(env: PushEnv, task: _Pushes) -> int:
    rng = np.random.default_rng(task.seed)
    for _ in range(task.num_pushes):
        env.reset(seed=int(rng.integers(2**31)))
        draw = touching_action if rng.random() < task.hit_share else uniform_action
        env.step(draw(env, rng))
    return task.num_pushes


def _map(
    engine: LocalEngine, begin: int, end: int, resolution: int, on_progress: OnProgress
) -> None:
    for seed in range(begin, end):
        compute_reward_map(RewardMapRequest(make_poses(SCENARIO, seed), resolution), engine)
        on_progress(1)
