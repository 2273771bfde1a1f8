"""Benchmarks by name; a new one is one entry here."""

from collections.abc import Callable, Iterator

from singulate.bench.dashboard import bench_dashboard
from singulate.bench.env import bench_env
from singulate.bench.growth import bench_growth
from singulate.bench.learning import bench_learning
from singulate.bench.measurement import BenchOptions, Measurement
from singulate.bench.rewardmap import bench_rewardmap
from singulate.bench.training import bench_training

BENCHMARKS: dict[str, Callable[[BenchOptions], Iterator[Measurement]]] = {
    "env": bench_env,
    "rewardmap": bench_rewardmap,
    "growth": bench_growth,
    "training": bench_training,
    "dashboard": bench_dashboard,
    "learning": bench_learning,
}

USUAL_BENCHMARKS = tuple(name for name in BENCHMARKS if name != "learning")
"""Those that are run where none is named; whole trainings over seeds take most of an hour."""
