"""``singulate reproduce``: the paper's figures and claims."""

import argparse
import json
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from singulate.cli.engine_options import add_engine_options, engine_of
from singulate.cli.lists import parse_seeds
from singulate.cli.progress import StepBars
from singulate.cli.targets import check_directory_target
from singulate.exceptions import InvalidValueError

if TYPE_CHECKING:
    from singulate.experiments.figures.plan import Plan
    from singulate.experiments.reproduce import Reproduction

    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

FIGURES_DIRECTORY = Path("static/figures")
QUICK_DIRECTORY = Path("runs/reproduce/quick")


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "the paper's figures, and a verdict on each of its claims and ideas"
    parser = subparsers.add_parser(
        "reproduce",
        help=text,
        description=f"{text}; run it again to go on where it was interrupted",
    )
    parser.add_argument(
        "figures",
        nargs="*",
        metavar="fig1 ... fig6 | autoencoder | ideas | all",
        help="(all, which judges the claims)",
    )
    parser.add_argument("--seeds", metavar="0,1|0-4", help="of the trainings (0-2)")
    parser.add_argument(
        "--steps",
        type=int,
        help="longest training, but for those whose length the paper gives (60000)",
    )
    parser.add_argument("--jobs", type=int, help="trainings at the same time (one a core)")
    parser.add_argument(
        "--quick",
        action="store_true",
        help="minutes instead of hours: one seed, one update of PPO; proves nothing",
    )
    parser.add_argument(
        "--no-training",
        action="store_true",
        help="draw and judge what is finished, or has its numbers in --out",
    )
    parser.add_argument(
        "--reuse",
        action="store_true",
        help="do not repeat trainings whose numbers lie in --out already",
    )
    parser.add_argument(
        "--out",
        type=Path,
        metavar="DIR",
        help=f"({FIGURES_DIRECTORY}; with --quick {QUICK_DIRECTORY}, which proves nothing either)",
    )
    parser.add_argument(
        "--runs",
        type=Path,
        default=Path("runs/reproduce"),
        metavar="DIR",
        help="where the trainings lie (%(default)s)",
    )
    add_engine_options(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    from singulate.experiments.figures.paper_figure import Sources
    from singulate.experiments.figures.published import Published
    from singulate.experiments.figures.registry import FIGURES, parse_figures
    from singulate.experiments.reproduce import open_store, reproduce

    figures, is_all = parse_figures(args.figures)
    plan = _plan(args)
    if args.jobs is not None:
        if args.workers is not None:
            raise InvalidValueError("--workers", args.workers, "nothing beside --jobs")
        args.workers = args.jobs
    if args.out is None:
        args.out = QUICK_DIRECTORY if args.quick else FIGURES_DIRECTORY
    check_directory_target("out", args.out)
    check_directory_target("runs", args.runs)
    is_reusing = args.reuse or args.no_training
    published = Published.read(args.out, list(FIGURES)) if is_reusing else Published()
    began = time.monotonic()
    with engine_of(args, niceness=5, hang_timeout_s=float("inf")) as engine, StepBars() as bars:
        made = reproduce(
            figures,
            Sources(plan, open_store(args.runs), engine, published),
            args.out,
            with_claims=is_all,
            with_training=not args.no_training,
            on_progress=bars.show,
        )
    _report(args, made, time.monotonic() - began)
    for name, reason in made.failures.items():
        print(f"singulate: error: {name}: {reason}", file=sys.stderr)
    return 2 if made.failures else 0


def _plan(args: argparse.Namespace) -> "Plan":
    from singulate.experiments.figures.plan import Plan, quick_plan

    plan = quick_plan() if args.quick else Plan()
    if args.seeds is not None:
        plan = replace(plan, seeds=tuple(parse_seeds("seeds", args.seeds)))
    return plan if args.steps is None else replace(plan, max_steps=args.steps)


def _report(args: argparse.Namespace, made: "Reproduction", seconds: float) -> None:
    if args.json:
        about: dict[str, Any] = {
            "out": str(args.out),
            "written": [str(path) for path in made.written],
            "unfinished": made.unfinished,
            "failures": made.failures,
            "num_computed": made.num_computed,
            "claims": {claim.key: claim.verdict for claim in made.claims},
            "seconds": round(seconds, 1),
        }
        print(json.dumps(about))
        return
    console = Console()
    if made.claims:
        table = Table("claim", "verdict", box=None)
        for claim in made.claims:
            table.add_row(claim.statement, claim.verdict)
        console.print(table)
    for name in made.unfinished:
        console.print(f"{name}: not drawn, its trainings are not finished")
    console.print(
        f"{len(made.written)} files in {args.out}, {made.num_computed} trainings finished now, "
        f"{seconds:.0f} s",
        highlight=False,
    )
