"""The ``singulate`` command: one module a subcommand, imported when it is asked for."""

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

from singulate.exceptions import SingulateError

COMMANDS: dict[str, str] = {
    "app": "open the dashboard in a browser",
    "train": "train an agent",
    "agents": "the agents that can be trained, and the settings of each",
    "evaluate": "success and rewards of a trained agent on unseen scenes",
    "ceiling": "share of scenes that some push of a grid solves",
    "rewardmap": "true reward of every push on a scene",
    "dataset": "reward maps of many scenes, to learn from",
    "autoencoder": "learn a small code of the distance map, as a state for agents",
    "sweep": "train and evaluate every combination of agents, scenarios, settings and seeds",
    "reproduce": "the paper's figures, and a verdict on each of its claims",
    "runs": "list, show, steer, export and delete training runs",
    "bench": "measure speeds on this machine",
    "soak": "memory of one process over many pushes and reward maps",
    "exactness": "compare every shortcut of the simulation with the plain push",
}
"""Every subcommand is a module of this package with an ``add_parser(subparsers)``."""

EXIT_ERROR = 2
EXIT_INTERRUPTED = 130


class OneLineParser(argparse.ArgumentParser):
    """A parser whose errors are one line, and say what is allowed."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.register("type", int, _whole_number)
        self.register("type", float, _number)
        self.register("type", Path, _path)

    def error(self, message: str) -> NoReturn:
        """Print the error and exit with status 2."""
        self.exit(EXIT_ERROR, f"singulate: error: {' '.join(message.split())}\n")


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command line.

    Args:
        argv: Arguments without the program's name; the process's own by default.

    Returns:
        Exit status: 0, 2 after one line about what was wrong, or 130 after Ctrl-C.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    try:
        args = _make_parser(arguments).parse_args(arguments)
        status: int = args.run(args)
        sys.stdout.flush()
        return status
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED
    except BrokenPipeError:
        # Whoever read the output has gone; nothing more can be said there, even at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return EXIT_ERROR
    except SingulateError as error:
        return _fail(str(error))
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return _fail(f"{where}{error.strerror or error}")


def _make_parser(arguments: Sequence[str]) -> argparse.ArgumentParser:
    parser = OneLineParser(
        prog="singulate", description="A laboratory for telling objects apart by pushing them."
    )
    subparsers = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    wanted = next((word for word in arguments if not word.startswith("-")), None)
    for name, text in COMMANDS.items():
        if name == wanted:
            import_module(f"singulate.cli.{name}").add_parser(subparsers)
        else:
            subparsers.add_parser(name, help=text, add_help=False)
    return parser


def _whole_number(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(_not_allowed(text, "a whole number")) from None


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(_not_allowed(text, "a number")) from None


def _path(text: str) -> Path:
    if not text:
        raise argparse.ArgumentTypeError(_not_allowed(text, "a path; . is the current directory"))
    return Path(text)


def _not_allowed(text: str, allowed: str) -> str:
    return f"{text!r} is not allowed; allowed: {allowed}"


def _fail(message: str) -> int:
    print(f"singulate: error: {' '.join(message.split())}", file=sys.stderr)
    return EXIT_ERROR
