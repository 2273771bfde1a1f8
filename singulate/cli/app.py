"""``singulate app``: the dashboard."""

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser; its options are those of ``python -m app``."""
    # The prefix character cannot occur in an argument, so that all of them are passed on.
    parser = subparsers.add_parser(
        "app", help="open the dashboard in a browser", add_help=False, prefix_chars="\0"
    )
    parser.add_argument("arguments", nargs="*")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    """Become the dashboard that belongs to this package, whatever the directory holds."""
    sys.stdout.flush()
    command = [sys.executable, "-P", "-m", "app", *args.arguments]
    package_parent = str(Path(__file__).resolve().parents[2])
    path = os.pathsep.join(filter(None, (package_parent, os.environ.get("PYTHONPATH"))))
    os.execve(sys.executable, command, os.environ | {"PYTHONPATH": path})
