"""How the cost of pushes and of reward maps grows with the work and with the workers."""

from collections.abc import Iterator
from contextlib import ExitStack
from typing import NamedTuple

import numpy as np

from singulate.bench.maps import make_poses, seconds_to_levels
from singulate.bench.measurement import BenchOptions, Measurement
from singulate.bench.memory import workers_peak_mib
from singulate.bench.pushes import make_env, push_touching
from singulate.bench.turns import Variant, take_turns
from singulate.engine import LocalEngine

NUM_BLOCKS = (2, 3, 4, 6, 8)
RESOLUTIONS = (16, 32, 64, 128)
_USUAL_BLOCKS = 3
_USUAL_RESOLUTION = 64
_PUSH_SHARE = 0.4
"""Part of a measurement's usual seconds that each number of blocks and of workers gets."""


class Point(NamedTuple):
    """A reward map on a curve.

    Attributes:
        axis: What grows.
        at: How far it has grown.
        num_blocks: In a row.
        resolution: Starts along each side.
        num_workers: Processes.
    """

    axis: str
    at: int
    num_blocks: int
    resolution: int
    num_workers: int


def bench_growth(options: BenchOptions) -> Iterator[Measurement]:
    """Touching pushes and whole maps, along one axis at a time."""
    with ExitStack() as stack:
        engines = {
            n: stack.enter_context(LocalEngine(n, niceness=0)) for n in options.worker_counts
        }
        yield from _maps(engines, options)
        yield from _pushes(engines, options)
        most = engines[options.worker_counts[-1]]
        yield Measurement("peak memory", workers_peak_mib(most), "MiB", "resident, largest worker")


def _maps(engines: dict[int, LocalEngine], options: BenchOptions) -> Iterator[Measurement]:
    """Every point is measured once a round, on another scene in each round.

    A map takes long where there is much to do, so half as many scenes have to do as elsewhere.
    """
    num_scenes = (options.num_repeats + 1) // 2
    points = _points(options.worker_counts)
    cases = {point[2:] for point in points}
    seconds: dict[tuple[int, ...], list[float]] = {case: [] for case in cases}
    for engine in engines.values():
        seconds_to_levels(engine, make_poses("random-2", 0), resolution=8)
    for seed in range(num_scenes):
        for case, found in seconds.items():
            num_blocks, resolution, num_workers = case
            poses = make_poses(f"random-{num_blocks}", seed)
            found.append(seconds_to_levels(engines[num_workers], poses, resolution)[resolution])
    for point in points:
        mean = float(np.mean(seconds[point[2:]]))
        note = (
            f"random-{point.num_blocks}, {point.resolution} x {point.resolution}, "
            f"{_workers(point.num_workers)}, mean of {num_scenes} scenes"
        )
        yield Measurement("reward map", mean, "s", note, point.axis, point.at)


def _points(worker_counts: tuple[int, ...]) -> list[Point]:
    most = worker_counts[-1]
    blocks, resolution = _USUAL_BLOCKS, _USUAL_RESOLUTION
    return [
        *(Point("blocks", n, n, resolution, most) for n in NUM_BLOCKS),
        *(Point("pixels", n, blocks, n, most) for n in RESOLUTIONS),
        *(Point("workers", n, blocks, resolution, n) for n in worker_counts),
    ]


def _pushes(engines: dict[int, LocalEngine], options: BenchOptions) -> Iterator[Measurement]:
    cases = [("blocks", n, n, 1) for n in NUM_BLOCKS]
    cases += [("workers", n, _USUAL_BLOCKS, n) for n in engines]
    variants = {
        f"{axis} {at}": Variant(engines[workers], push_touching, make_env(f"random-{blocks}"))
        for axis, at, blocks, workers in cases
    }
    rates = take_turns(variants, _PUSH_SHARE * options.seconds)
    for axis, at, blocks, workers in cases:
        note = f"random-{blocks}, reset and step, {_workers(workers)}"
        rate = rates[f"{axis} {at}"].steps
        yield Measurement("touching pushes", rate, "pushes/s", note, axis, at)


def _workers(count: int) -> str:
    return f"{count} worker{'s' * (count > 1)}"
