"""``singulate agents``: what can be trained, and what can be set of it."""

import argparse
import json
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from singulate.agents.registry import AGENTS
from singulate.agents.settings import settings_of

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "the agents that can be trained, or the settings of one of them"
    parser = subparsers.add_parser("agents", help=text, description=text)
    parser.add_argument("agent", nargs="?", metavar="AGENT", help=", ".join(AGENTS))
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    if args.agent is None:
        _list_agents(args.json)
    else:
        _list_settings(args.agent, args.json)
    return 0


def _list_agents(is_json: bool) -> None:
    if is_json:
        print(json.dumps({name: {"actions": kind.actions} for name, kind in AGENTS.items()}))
        return
    table = Table("agent", "--action", box=None)
    for name, kind in AGENTS.items():
        table.add_row(name, " or ".join(kind.actions))
    Console().print(table)


def _list_settings(agent: str, is_json: bool) -> None:
    settings = settings_of(agent)
    if is_json:
        print(json.dumps([setting._asdict() for setting in settings]))
        return
    table = Table(box=None)
    table.add_column("--set", no_wrap=True)
    table.add_column("default", no_wrap=True)
    table.add_column("meaning")
    for setting in settings:
        table.add_row(setting.name, json.dumps(setting.default), setting.meaning)
    Console().print(table)
