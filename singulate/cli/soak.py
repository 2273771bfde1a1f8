"""``singulate soak``: memory of one process over many pushes and reward maps."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from singulate.bench.soak import SoakedMemory, SoakOptions, soak
from singulate.cli.targets import check_file_target

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    defaults = SoakOptions()
    text = "memory of one process over many pushes and reward maps"
    parser = subparsers.add_parser("soak", help=text, description=text)
    parser.add_argument("--pushes", type=int, default=defaults.num_pushes, help="(%(default)s)")
    parser.add_argument("--maps", type=int, default=defaults.num_maps, help="(%(default)s)")
    parser.add_argument(
        "--hits",
        type=float,
        default=defaults.hit_share,
        metavar="SHARE",
        help="pushes drawn so that they meet a block; the rest is random (%(default)s)",
    )
    parser.add_argument(
        "--resolution", type=int, default=defaults.resolution, help="of the maps (%(default)s)"
    )
    parser.add_argument("--out", type=Path, metavar="FILE", help="write the JSON there")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    options = SoakOptions(args.pushes, args.maps, args.hits, args.resolution)
    if args.out is not None:
        check_file_target("out", args.out)
    with Progress(console=Console(stderr=True)) as progress:
        pushes = progress.add_task("pushes", total=options.num_pushes)
        maps = progress.add_task("reward maps", total=options.num_maps)
        results = soak(
            options,
            on_push=lambda count: progress.advance(pushes, count),
            on_map=lambda count: progress.advance(maps, count),
        )
    if args.out is not None:
        args.out.write_text(results.to_json() + "\n")
    if args.json:
        print(results.to_json())
        return 0
    for memory in (results.pushes, results.reward_maps):
        Console().print(_table(memory))
    return 0


def _table(memory: SoakedMemory) -> Table:
    title = f"{memory.what} ({memory.seconds:.0f} s): {memory.growth_mib:+.1f} MiB"
    table = Table(title=title, title_justify="left", box=None)
    for column in ("done", "worker [MiB]", "parent [MiB]"):
        table.add_column(column, justify="right")
    for done, worker, parent in zip(
        memory.num_done, memory.worker_mib, memory.parent_mib, strict=True
    ):
        table.add_row(f"{done:,}", f"{worker:.1f}", f"{parent:.1f}")
    return table
