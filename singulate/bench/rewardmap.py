"""Seconds from a scene to its coarse and to its full reward map."""

import functools
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple, TypeVar

import numpy as np

from singulate.bench.maps import make_poses, seconds_to_levels
from singulate.bench.measurement import BenchOptions, Measurement
from singulate.bench.memory import workers_peak_mib
from singulate.engine import LocalEngine
from singulate.rewardmap import RewardMapRequest
from singulate.rewardmap.plain_pushes import Cells, PushTasks, simulate, survey
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.shared_trajectories import LinesTask, simulate_lines, split_into_lines

SCENARIO = "random-3"
RESOLUTION = 64
GOAL_SEPARATION = 0.1
_NUM_PLAIN_PUSHES = 150
_TURNS_PER_REPEAT = 4

TaskT = TypeVar("TaskT")


class _PlainTask(NamedTuple):
    request: RewardMapRequest
    cells: Cells


def bench_rewardmap(options: BenchOptions) -> Iterator[Measurement]:
    """Time maps of several scenes with workers that have started."""
    with LocalEngine(options.num_workers, niceness=0) as engine:
        seconds_to_start = seconds_to_levels(engine, make_poses(SCENARIO, 0), resolution=8)[8]
        by_level: dict[int, list[float]] = {}
        for seed in range(options.num_repeats):
            levels = seconds_to_levels(engine, make_poses(SCENARIO, seed), RESOLUTION)
            for level, seconds in levels.items():
                by_level.setdefault(level, []).append(seconds)
        peak = workers_peak_mib(engine)
        note = f"{SCENARIO}, {engine.num_workers} workers, median of {options.num_repeats} scenes"
    for level, samples in sorted(by_level.items()):
        kind = "full map" if level == RESOLUTION else "coarse map"
        yield Measurement(f"{kind}, {level} x {level}", float(np.median(samples)), "s", note)
    yield Measurement("first coarse map", seconds_to_start, "s", "with the start of the workers")
    yield from _gain(options)
    yield Measurement("peak memory", peak, "MiB", "resident, of the largest worker")


def _gain(options: BenchOptions) -> Iterator[Measurement]:
    """One core: a full map by shared trajectories against a plain push for each of its starts."""
    rng = np.random.default_rng(0)
    num_starts = 4 * RESOLUTION**2
    shared, plain, num_plain = 0.0, 0.0, 0
    num_turns = _TURNS_PER_REPEAT * options.num_repeats
    with LocalEngine(1, niceness=0) as engine:
        for seed in range(num_turns):
            request = RewardMapRequest(make_poses(SCENARIO, seed), RESOLUTION)
            cells = rng.choice(num_starts, size=_NUM_PLAIN_PUSHES, replace=False)
            shared += _seconds(engine, _time_shared, request, exact=False)
            plain += _seconds(engine, _time_plain, _PlainTask(request, cells), exact=True)
            num_plain += cells.size
    per_map = plain / num_plain * num_starts
    note = f"{SCENARIO}, {RESOLUTION} x {RESOLUTION}, one process, mean of {num_turns}"
    shared /= num_turns
    yield Measurement("full map, shared trajectories", shared, "s", note)
    sample = f"a plain push for each start, from {num_plain} random ones"
    yield Measurement("full map, plain pushes", per_map, "s", sample)
    yield Measurement("full map, gain", per_map / shared, "", "shared trajectories against plain")


def _seconds(
    engine: LocalEngine, work: Callable[[Prober, TaskT], float], task: TaskT, exact: bool
) -> float:
    tool = functools.partial(Prober, GOAL_SEPARATION, exact=exact)
    (result,) = engine.submit(work, [task], tool)
    return result.value


def _time_shared(prober: Prober, request: RewardMapRequest) -> float:
    """Seconds for a whole map."""
    began = time.perf_counter()
    is_open = np.isnan(survey(prober, (request, request.resolution)))
    simulate_lines(prober, LinesTask(request, request.resolution, split_into_lines(is_open)))
    return time.perf_counter() - began


def _time_plain(prober: Prober, task: _PlainTask) -> float:
    """Seconds for a plain push from each of some cells."""
    began = time.perf_counter()
    simulate(prober, PushTasks(task.request, task.request.resolution, task.cells))
    return time.perf_counter() - began
