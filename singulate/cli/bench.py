"""``singulate bench``: how fast things are on this machine."""

import argparse
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from singulate.bench import (
    BENCHMARKS,
    USUAL_BENCHMARKS,
    BenchOptions,
    Measurement,
    describe_machine,
)
from singulate.bench.page import check_page, fill_page
from singulate.bench.plot import check_plot_target, save_plot
from singulate.bench.results import BenchResults, read_results
from singulate.bench.soak import read_soak
from singulate.cli.targets import check_file_target
from singulate.exceptions import InvalidValueError, SingulateError

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    defaults = BenchOptions()
    text = "speed of pushes, of learning and of reward maps; the page's response and cost"
    parser = subparsers.add_parser("bench", help=text, description=text)
    parser.add_argument(
        "names",
        nargs="*",
        metavar="NAME",
        help=f"{', '.join(BENCHMARKS)} (default: {', '.join(USUAL_BENCHMARKS)})",
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
    parser.add_argument(
        "--seeds",
        type=int,
        default=defaults.num_seeds,
        help="trainings of each agent, for learning (%(default)s)",
    )
    parser.add_argument(
        "--read", type=Path, metavar="JSON", help="show numbers that were printed by --json"
    )
    parser.add_argument("--out", type=Path, metavar="FILE", help="write the JSON there")
    parser.add_argument(
        "--plot", type=Path, metavar="FILE", help="draw the curves, as .png or .svg"
    )
    parser.add_argument(
        "--page",
        type=Path,
        metavar="FILE",
        help="replace the tables of a Markdown page; those of memory are read from memory.json "
        "beside it",
    )
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    for name in args.names:
        if name not in BENCHMARKS:
            raise InvalidValueError("benchmark", name, ", ".join(BENCHMARKS))
    options = BenchOptions(args.seconds, args.repeats, args.workers, args.seeds)
    for key in ("out", "plot", "page"):
        if getattr(args, key) is not None:
            check_file_target(key, getattr(args, key))
    if args.plot is not None:
        check_plot_target(args.plot)
    names = args.names or USUAL_BENCHMARKS
    if args.page is not None and args.read is None:
        check_page(_text_of(args.page), names)
        read_soak(_memory_of(args.page))
    console = Console(stderr=args.json)
    if args.read is None:
        results = _measure(names, options, console, not args.json)
    else:
        results = _read(args.read, args.names)
        if not args.json:
            _print(results, console)
    _save(results, args.out, args.plot, args.page)
    if args.json:
        print(results.to_json())
    else:
        machine = ", ".join(f"{key}: {value}" for key, value in results.machine.items())
        console.print(machine, style="dim")
    return 0


def _save(results: BenchResults, out: Path | None, plot: Path | None, page: Path | None) -> None:
    if out is not None:
        out.write_text(results.to_json() + "\n")
    if plot is not None:
        save_plot(results, plot)
    if page is not None:
        page.write_text(fill_page(_text_of(page), results, read_soak(_memory_of(page))))


def _memory_of(page: Path) -> Path:
    return page.parent / "memory.json"


def _text_of(page: Path) -> str:
    try:
        return page.read_text()
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "this is no text"
        raise InvalidValueError("page", str(page), f"a page of Markdown ({why})") from None


def _measure(
    names: Sequence[str], options: BenchOptions, console: Console, is_shown: bool
) -> BenchResults:
    """Run benchmarks; of one that breaks off, what it has measured is printed all the same."""
    results = BenchResults(describe_machine(), {}, {})
    for name in names:
        began = time.monotonic()
        measured = results.benchmarks[name] = []
        results.seconds[name] = 0.0
        try:
            with console.status(f"measuring: {name}"):
                for measurement in BENCHMARKS[name](options):
                    measured.append(measurement)
                    results.seconds[name] = round(time.monotonic() - began, 1)
        except SingulateError:
            if not is_shown:
                print(results.to_json())
            raise
        finally:
            if is_shown:
                console.print(_table(name, measured, results.seconds[name]))
    return results


def _read(path: Path, names: Sequence[str]) -> BenchResults:
    results = read_results(path)
    for name in names:
        if name not in results.benchmarks:
            raise InvalidValueError(
                "benchmark", name, f"of {path}: {', '.join(results.benchmarks)}"
            )
    kept = names or list(results.benchmarks)
    return BenchResults(
        results.machine,
        {name: results.benchmarks[name] for name in kept},
        {name: results.seconds[name] for name in kept},
    )


def _print(results: BenchResults, console: Console) -> None:
    for name, measurements in results.benchmarks.items():
        console.print(_table(name, measurements, results.seconds[name]))


def _table(name: str, measurements: Sequence[Measurement], seconds: float) -> Table:
    table = Table(title=f"{name} ({seconds:.0f} s)", title_justify="left", box=None)
    table.add_column("what")
    table.add_column("value", justify="right")
    table.add_column("unit")
    table.add_column("how", style="dim")
    for each in measurements:
        what = each.name if each.at is None else f"{each.name}, {each.at:g} {each.axis}"
        value = "-" if each.value is None else f"{each.value:.4g}"
        table.add_row(what, value, each.unit, escape(each.note))
    return table
