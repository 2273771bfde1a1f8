"""How fast things are on this machine."""

from singulate.bench.benchmarks import BENCHMARKS, USUAL_BENCHMARKS
from singulate.bench.machine import describe_machine
from singulate.bench.measurement import BenchOptions, Measurement

__all__ = [
    "BENCHMARKS",
    "USUAL_BENCHMARKS",
    "BenchOptions",
    "Measurement",
    "describe_machine",
]
