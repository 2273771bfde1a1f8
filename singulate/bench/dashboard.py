"""The page while an agent trains: how soon a click moves the pusher, what the page costs."""

from collections.abc import Iterator

from singulate.bench.measurement import BenchOptions, Measurement


def bench_dashboard(options: BenchOptions) -> Iterator[Measurement]:
    """Placeholder."""
    yield from ()
