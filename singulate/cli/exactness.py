"""``singulate exactness``: every shortcut against the plain push."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from singulate.cli.targets import check_file_target
from singulate.exceptions import InvalidValueError

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

_MAX_COUNT = 1_000_000


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "compare every shortcut of the simulation with the plain push, and that with itself"
    parser = subparsers.add_parser(
        "exactness",
        help=text,
        description=f"{text} started 1 mm further back",
    )
    parser.add_argument("--pushes", type=int, default=2000, help="random pushes (%(default)s)")
    parser.add_argument("--scenes", type=int, default=50, help="reward maps (%(default)s)")
    parser.add_argument("--seed", type=int, default=0, help="draws both (%(default)s)")
    parser.add_argument("--out", type=Path, metavar="FILE", help="write the JSON there")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    from singulate.experiments.exactness import compare_maps, compare_pushes

    for key in ("pushes", "scenes"):
        if not 1 <= getattr(args, key) <= _MAX_COUNT:
            raise InvalidValueError(key, getattr(args, key), f"1 to {_MAX_COUNT}")
    if args.seed < 0:
        raise InvalidValueError("seed", args.seed, "0 or more")
    if args.out is not None:
        check_file_target("out", args.out)
    rng = np.random.default_rng(args.seed)
    with Progress(console=Console(stderr=True)) as progress:
        pushes = progress.add_task("pushes", total=args.pushes)
        maps = progress.add_task("reward maps", total=args.scenes)
        report = {
            "seed": args.seed,
            "pushes": compare_pushes(args.pushes, rng, lambda: progress.advance(pushes)),
            "reward_maps": compare_maps(
                args.scenes, rng, on_progress=lambda: progress.advance(maps)
            ),
        }
    text = json.dumps(report, indent=2)
    if args.out is not None:
        args.out.write_text(text + "\n")
    if args.json:
        print(text)
    else:
        Console().print(_table(report))
    return 0


def _table(report: dict[str, Any]) -> Table:
    table = Table("compared", "pushes", "same success", "reward error", "moved")
    table.columns[0].no_wrap = True
    for part in ("pushes", "reward_maps"):
        for name, found in report[part].items():
            table.add_row(
                f"{part.replace('_', ' ')}: {name}",
                f"{found['num_pushes']:,}",
                f"{found['success_agreement']:.2%}",
                _quantiles(found["reward_error"], ""),
                _quantiles(found["displacement_mm"], " mm"),
            )
    table.caption = "against the plain push; errors at the 50th, 90th and 99th percentile"
    return table


def _quantiles(found: dict[str, float], unit: str) -> str:
    return ", ".join(f"{value:.3g}" for value in found.values()) + unit if found else ""
