"""Seconds from a scene to its coarse and to its full reward map."""

import time
from collections.abc import Iterator

import numpy as np

from singulate.bench.measurement import BenchOptions, Measurement
from singulate.engine import LocalEngine
from singulate.geometry import Poses, Workspace, standing_pose
from singulate.rewardmap import RewardMapRequest, refine_levels
from singulate.simulation import make_scenario

SCENARIO = "random-3"
RESOLUTION = 64


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
