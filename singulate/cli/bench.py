"""``singulate bench``: how fast things are on this machine."""

import argparse
import json
import time
from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from singulate.bench import BENCHMARKS, BenchOptions, Measurement, describe_machine
from singulate.exceptions import InvalidValueError

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    defaults = BenchOptions()
    text = "speed of pushes, of learning and of reward maps; the page's response and cost"
    parser = subparsers.add_parser("bench", help=text, description=text)
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help=f"{', '.join(BENCHMARKS)} (default: all)"
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=defaults.seconds,
        help="time for each measurement that is taken by the clock (%(default)s)",
    )
    parser.add_argument(
        "--repeats",
        type=int,
        default=defaults.num_repeats,
        help="scenes or runs behind a median (%(default)s)",
    )
    parser.add_argument("--workers", type=int, help="worker processes (one a core)")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    for name in args.names:
        if name not in BENCHMARKS:
            raise InvalidValueError("benchmark", name, ", ".join(BENCHMARKS))
    options = BenchOptions(args.seconds, args.repeats, args.workers)
    machine = describe_machine()
    console = Console(stderr=args.json)
    results: dict[str, list[dict[str, object]]] = {}
    for name in args.names or BENCHMARKS:
        began = time.monotonic()
        with console.status(f"measuring: {name}"):
            measurements = list(BENCHMARKS[name](options))
        results[name] = [asdict(measurement) for measurement in measurements]
        if not args.json:
            console.print(_table(name, measurements, time.monotonic() - began))
    if args.json:
        print(json.dumps({"machine": machine, "benchmarks": results}))
    else:
        console.print(", ".join(f"{key}: {value}" for key, value in machine.items()), style="dim")
    return 0


def _table(name: str, measurements: Sequence[Measurement], seconds: float) -> Table:
    table = Table(title=f"{name} ({seconds:.0f} s)", title_justify="left", box=None)
    table.add_column("what")
    table.add_column("value", justify="right")
    table.add_column("unit")
    table.add_column("how", style="dim")
    for measurement in measurements:
        table.add_row(
            measurement.name, f"{measurement.value:.4g}", measurement.unit, measurement.note
        )
    return table
