"""How fast things are on this machine."""

from singulate.bench.benchmarks import BENCHMARKS
from singulate.bench.machine import describe_machine
from singulate.bench.measurement import BenchOptions, Measurement

__all__ = ["BENCHMARKS", "BenchOptions", "Measurement", "describe_machine"]
