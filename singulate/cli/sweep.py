"""``singulate sweep``: train and evaluate every combination of agents, scenarios and settings."""

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from singulate.cli.engine_options import add_engine_options, engine_of
from singulate.cli.lists import parse_names, parse_seeds, parse_setting
from singulate.cli.progress import CountBar
from singulate.cli.targets import check_directory_target
from singulate.exceptions import InvalidValueError

if TYPE_CHECKING:
    from singulate.experiments.cell import Cell
    from singulate.experiments.run_cells import CellProgress, Outcome

    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "train and evaluate every combination of agents, scenarios, settings and seeds"
    parser = subparsers.add_parser(
        "sweep",
        help=text,
        description=f"{text}; run it again to go on where it was interrupted",
    )
    parser.add_argument("--agents", default="dqn", metavar="A,B", help="(%(default)s)")
    parser.add_argument("--scenarios", default="random-2", metavar="A,B", help="(%(default)s)")
    parser.add_argument("--seeds", default="0-2", metavar="0,1|0-4", help="(%(default)s)")
    parser.add_argument("--steps", type=int, default=20_000, help="pushes of each (%(default)s)")
    parser.add_argument(
        "--set",
        dest="settings",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="a setting of all cells: learning_rate, dqn.learning_rate (of this agent only), "
        "env.reward",
    )
    parser.add_argument(
        "--vary",
        dest="axes",
        action="append",
        default=[],
        metavar="KEY=[V,W]",
        help="values of a setting, a JSON list; may be given several times",
    )
    parser.add_argument("--episodes", type=int, default=1000, help="(%(default)s)")
    parser.add_argument(
        "--evaluation-seed", type=int, default=7, help="decides the unseen scenes (%(default)s)"
    )
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="cells and tables")
    add_engine_options(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    from singulate.experiments.cell_store import CellStore
    from singulate.experiments.run_cells import run_cells

    cells = _cells(args)
    check_directory_target("out", args.out)
    store = CellStore(args.out / "cells")
    with CountBar("Pushes", sum(cell.training.total_timesteps for cell in cells)) as bar:

        def show(progress: "CellProgress") -> None:
            bar.set(progress.num_steps, f"{progress.num_finished} of {len(cells)} cells")

        outcome = run_cells(
            cells,
            store,
            lambda: engine_of(args, niceness=5, hang_timeout_s=float("inf")),
            on_progress=show,
        )
    _write(args, outcome)
    for name, reason in outcome.failures.items():
        print(f"singulate: error: {name}: {reason}", file=sys.stderr)
    return 2 if outcome.failures else 0


def _cells(args: argparse.Namespace) -> "list[Cell]":
    from singulate.agents.config_fields import check_int
    from singulate.experiments.grid import combinations, make_cells

    check_int("episodes", args.episodes, 1, 10_000_000)
    check_int("evaluation_seed", args.evaluation_seed, 0, 2**63 - 1)
    agents = parse_names("agents", args.agents)
    fixed = dict(parse_setting("--set", text) for text in args.settings)
    axes: dict[str, Any] = dict(parse_setting("--vary", text) for text in args.axes)
    given = [text.partition("=")[0] for text in args.settings + args.axes]
    for key in given:
        _check_setting(key, given.count(key), agents)
    for key, values in axes.items():
        if not isinstance(values, list) or not values:
            raise InvalidValueError("--vary", f"{key}={values}", "KEY=[V,W], a JSON list of values")
    return make_cells(
        agents,
        parse_names("scenarios", args.scenarios),
        [fixed | combination for combination in combinations(axes)],
        parse_seeds("seeds", args.seeds),
        steps=args.steps,
        episodes=args.episodes,
        evaluation_seed=args.evaluation_seed,
    )


def _check_setting(key: str, num_given: int, agents: list[str]) -> None:
    """Refuse what would be passed over without a word."""
    if num_given > 1:
        raise InvalidValueError("--set and --vary", key, "each setting once, in one of them")
    if key == "env.scenario":
        raise InvalidValueError("--set and --vary", key, "other settings; --scenarios for this one")
    owner, dot, _ = key.rpartition(".")
    if dot and owner not in ("env", *agents):
        allowed = f"settings of env or of this sweep's agents, {', '.join(agents)}"
        raise InvalidValueError("--set and --vary", key, allowed)


def _write(args: argparse.Namespace, outcome: "Outcome") -> None:
    from singulate.experiments.results_plot import write_plot
    from singulate.experiments.results_table import pooled, table_row, write_csv, write_parquet

    rows = [table_row(cell, result) for cell, result in outcome.results]
    write_csv(args.out / "results.csv", rows)
    write_parquet(args.out / "results.parquet", rows)
    if rows:
        write_plot(args.out / "results.png", rows)
    summary = pooled(rows)
    if args.json:
        about = {"out": str(args.out), "num_computed": outcome.num_computed}
        print(json.dumps({**about, "failures": outcome.failures, "rows": rows, "pooled": summary}))
        return
    table = Table("agent", "scenario", "settings", "seeds", "success", "95 % interval", box=None)
    for group in summary:
        table.add_row(
            group["agent"],
            group["scenario"],
            group["settings"],
            str(group["num_seeds"]),
            f"{group['success_rate']:.1%}",
            f"{group['success_low']:.1%} to {group['success_high']:.1%}",
        )
    console = Console()
    console.print(table)
    console.print(f"{outcome.num_computed} cells computed now; tables and plot in {args.out}")
