"""``singulate app``: the dashboard."""

import argparse
import os
import sys
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
    sys.stdout.flush()
    os.execv(sys.executable, [sys.executable, "-m", "app", *args.arguments])
