"""``singulate runs``: what was trained here, what became of it, and what it shall do now."""

import argparse
import json
import math
import sys
from collections.abc import Callable
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from singulate.exceptions import RunError
from singulate.paths import default_runs_directory
from singulate.runs import (
    RunDirectory,
    RunReader,
    delete_run,
    export_run,
    list_runs,
    lock_holder,
    send_control,
)
from singulate.runs.listing import RunSummary, summarise_run

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

NUM_RECENT_PUSHES = 1000
PIPE_WIDTH = 200
"""Characters of a line that no terminal shows."""
CONTROLS = {
    "pause": "let a running trainer wait",
    "resume": "let a paused trainer go on",
    "stop": "let a running trainer save a checkpoint and end",
    "checkpoint": "let a running trainer save a checkpoint now",
}
"""Orders to a trainer; it follows at its next safe point."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    parser = subparsers.add_parser("runs", help="list, show, steer, export, delete training runs")
    actions = parser.add_subparsers(dest="action", required=True, metavar="ACTION")
    _add_action(actions, "list", "all runs, newest first", _list, takes_run=False)
    _add_action(actions, "show", "settings, state and results of a run", _show)
    for command, text in CONTROLS.items():
        _add_action(actions, command, text, _control)
    export = _add_action(actions, "export", "metrics and pushes of a run as CSV files", _export)
    export.add_argument(
        "--out", type=Path, required=True, metavar="DIR", help="directory for the files"
    )
    delete = _add_action(actions, "delete", "remove a run with everything in it", _delete)
    delete.add_argument("--yes", action="store_true", help="do not ask")


def _add_action(
    actions: "Subparsers",
    name: str,
    text: str,
    function: Callable[[argparse.Namespace], int],
    takes_run: bool = True,
) -> argparse.ArgumentParser:
    parser = actions.add_parser(name, help=text, description=text)
    if takes_run:
        parser.add_argument("run_name", metavar="RUN", help="name of a run, or its directory")
    parser.add_argument(
        "--runs-dir",
        type=Path,
        default=None,
        metavar="DIR",
        help="directory of all runs (default: $SINGULATE_RUNS or ./runs)",
    )
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=function)
    return parser


def _list(args: argparse.Namespace) -> int:
    directory = args.runs_dir or default_runs_directory()
    summaries = list_runs(directory)
    if args.json:
        _print_json([_summary_values(summary) for summary in summaries])
        return 0
    if not summaries:
        print(f"There are no runs in {directory}.")
        return 0
    table = Table(box=None)
    table.add_column("run", no_wrap=True)
    for title in ("agent", "scenario", "state", "steps", "updated"):
        table.add_column(title)
    for summary in summaries:
        status, config = summary.status, summary.config
        table.add_row(
            summary.name,
            str(config.get("agent", "?")),
            str(_scenario(config)),
            status.state if status else "damaged",
            f"{status.num_steps:,} / {status.total_steps:,}" if status else "?",
            _time_text(status.updated_at) if status else summary.problem,
        )
    Console(width=None if sys.stdout.isatty() else PIPE_WIDTH).print(table)
    return 0


def _show(args: argparse.Namespace) -> int:
    summary = summarise_run(_find(args))
    values = {**_summary_values(summary), **_results(summary.path)}
    if args.json:
        _print_json(values)
        return 0
    table = Table(show_header=False, box=None)
    table.add_column(style="bold")
    table.add_column(overflow="fold")
    for key, value in _flat(values):
        table.add_row(key, value)
    Console().print(table)
    return 0


def _control(args: argparse.Namespace) -> int:
    run_dir = _find(args)
    if lock_holder(run_dir) is None:
        raise RunError(
            f"{run_dir}: no trainer is running there; start one with "
            f"`singulate train --resume {run_dir}`"
        )
    send_control(run_dir, args.action)
    if args.json:
        _print_json({"run_dir": str(run_dir), "sent": args.action})
    else:
        print(f"Sent to the trainer of {run_dir}: {args.action}.")
    return 0


def _export(args: argparse.Namespace) -> int:
    paths = export_run(_find(args), args.out)
    if args.json:
        _print_json({"files": [str(path) for path in paths]})
    else:
        for path in paths:
            print(path)
    return 0


def _delete(args: argparse.Namespace) -> int:
    run_dir = _find(args)
    holder = lock_holder(run_dir)
    if holder is not None:
        raise RunError(f"{run_dir}: in use by process {holder or 'unknown'}; stop it first")
    if not args.yes and not _is_confirmed(run_dir):
        return 1
    delete_run(run_dir)
    if args.json:
        _print_json({"deleted": str(run_dir)})
    else:
        print(f"Deleted {run_dir}.")
    return 0


def _is_confirmed(run_dir: Path) -> bool:
    print(f"Delete {run_dir} with all its checkpoints? [y/N] ", end="", file=sys.stderr, flush=True)
    try:
        answer = input()
    except EOFError:
        raise RunError(f"{run_dir}: nobody confirmed the deletion; give --yes") from None
    return answer.strip().lower() in ("y", "yes")


def _find(args: argparse.Namespace) -> Path:
    named = (args.runs_dir or default_runs_directory()) / args.run_name
    path = named if RunDirectory(named).is_run else Path(args.run_name)
    if not RunDirectory(path).is_run:
        raise RunError(f"{args.run_name}: no run in {named.parent} and not a run directory")
    return path


def _summary_values(summary: RunSummary) -> dict[str, Any]:
    return {
        "name": summary.name,
        "path": str(summary.path),
        "problem": summary.problem,
        "status": asdict(summary.status) if summary.status else None,
        "config": summary.config,
    }


def _results(run_dir: Path) -> dict[str, Any]:
    reader = RunReader(run_dir)
    try:
        recent = reader.last_pushes(NUM_RECENT_PUSHES)
        series = {name: reader.metrics_since(name).values for name in reader.metric_names()}
        num_pushes = reader.count_pushes()
    finally:
        reader.close()
    last = {name: float(values[-1]) for name, values in series.items() if len(values)}
    checkpoint = RunDirectory(run_dir).latest_checkpoint()
    return {
        "num_pushes": num_pushes,
        "recent_success": sum(p.is_success for p in recent) / len(recent) if recent else None,
        "recent_reward": sum(p.reward for p in recent) / len(recent) if recent else None,
        "last_metrics": {k: v if math.isfinite(v) else None for k, v in last.items()},
        "latest_checkpoint": str(checkpoint) if checkpoint else None,
    }


def _scenario(config: dict[str, Any]) -> object:
    env = config.get("env")
    return env.get("scenario", "?") if isinstance(env, dict) else "?"


def _flat(values: dict[str, Any], prefix: str = "") -> list[tuple[str, str]]:
    rows: list[tuple[str, str]] = []
    for key, value in values.items():
        if isinstance(value, dict):
            rows += _flat(value, f"{prefix}{key}.")
        elif key == "updated_at":
            rows.append((prefix + key, _time_text(value)))
        elif value is not None and value != "":
            rows.append((prefix + key, f"{value:.6g}" if isinstance(value, float) else str(value)))
    return rows


def _time_text(seconds: float) -> str:
    return datetime.fromtimestamp(seconds, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")


def _print_json(values: object) -> None:
    print(json.dumps(values, indent=2, allow_nan=False))
