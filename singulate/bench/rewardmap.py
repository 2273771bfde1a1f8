"""Seconds from a scene to its coarse and to its full reward map."""

import time
from collections.abc import Iterator

import numpy as np

from singulate.bench.measurement import BenchOptions, Measurement
from singulate.engine import LocalEngine
from singulate.geometry import Poses, Workspace, standing_pose
from singulate.rewardmap import RewardMapRequest, refine_levels
from singulate.rewardmap.plain_pushes import PushTasks, simulate, survey
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.shared_trajectories import LinesTask, simulate_lines, split_into_lines
from singulate.simulation import make_scenario

SCENARIO = "random-3"
RESOLUTION = 64
GOAL_SEPARATION = 0.1
_NUM_PLAIN_PUSHES = 300


def bench_rewardmap(options: BenchOptions) -> Iterator[Measurement]:
    """Time maps of several scenes with workers that have started."""
    with LocalEngine(options.num_workers, niceness=0) as engine:
        seconds_to_start = _seconds_to_levels(engine, _scene(0), resolution=8)[8]
        by_level: dict[int, list[float]] = {}
        for seed in range(options.num_repeats):
            for level, seconds in _seconds_to_levels(engine, _scene(seed), RESOLUTION).items():
                by_level.setdefault(level, []).append(seconds)
        note = f"{SCENARIO}, {engine.num_workers} workers, median of {options.num_repeats} scenes"
    for level, samples in sorted(by_level.items()):
        kind = "full map" if level == RESOLUTION else "coarse map"
        yield Measurement(f"{kind}, {level} x {level}", float(np.median(samples)), "s", note)
    yield from _gain(options)
    yield Measurement("first coarse map", seconds_to_start, "s", "with the start of the workers")


def _scene(seed: int) -> Poses:
    layout = make_scenario(SCENARIO).sample(np.random.default_rng(seed), Workspace())
    return tuple(standing_pose(block) for block in layout)


def _seconds_to_levels(engine: LocalEngine, poses: Poses, resolution: int) -> dict[int, float]:
    """Seconds until each level is complete, by resolution."""
    began = time.perf_counter()
    return {
        reward_map.resolution: time.perf_counter() - began
        for reward_map in refine_levels(RewardMapRequest(poses, resolution), engine)
    }


def _gain(options: BenchOptions) -> Iterator[Measurement]:
    """One core: a full map by shared trajectories against a plain push for each of its starts."""
    rng = np.random.default_rng(0)
    shared, plain, num_plain = 0.0, 0.0, 0
    prober, plain_prober = Prober(GOAL_SEPARATION), Prober(GOAL_SEPARATION, exact=True)
    for seed in range(options.num_repeats):
        request = RewardMapRequest(_scene(seed), RESOLUTION)
        began = time.perf_counter()
        is_open = np.isnan(survey(prober, (request, RESOLUTION)))
        simulate_lines(prober, LinesTask(request, RESOLUTION, split_into_lines(is_open)))
        shared += time.perf_counter() - began
        cells = rng.choice(is_open.size, size=_NUM_PLAIN_PUSHES, replace=False)
        began = time.perf_counter()
        simulate(plain_prober, PushTasks(request, RESOLUTION, cells))
        plain += time.perf_counter() - began
        num_plain += cells.size
    prober.close()
    plain_prober.close()
    per_map = plain / num_plain * is_open.size
    note = f"{SCENARIO}, {RESOLUTION} x {RESOLUTION}, one process, mean of {options.num_repeats}"
    shared /= options.num_repeats
    yield Measurement("full map, shared trajectories", shared, "s", note)
    sample = f"a plain push for each start, from {num_plain} random ones"
    yield Measurement("full map, plain pushes", per_map, "s", sample)
    yield Measurement("full map, gain", per_map / shared, "", "shared trajectories against plain")
