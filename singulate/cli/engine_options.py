"""Where the work of a command runs: options that several commands share."""

import argparse

from singulate.engine import ENGINES, Engine, open_engine


def add_engine_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--engine``, ``--address`` and ``--workers``."""
    parser.add_argument(
        "--engine", default="local", metavar="|".join(ENGINES), help="(%(default)s)"
    )
    parser.add_argument(
        "--address",
        metavar="HOST:PORT",
        help="head of a Ray cluster, or auto (a Ray of its own on this machine)",
    )
    parser.add_argument("--workers", type=int, help="workers (one a core)")


def needs_engine(args: argparse.Namespace) -> bool:
    """Whether the options ask for more than this process."""
    return args.engine != "local" or args.address is not None or args.workers != 1


def engine_of(args: argparse.Namespace, niceness: int = 0, hang_timeout_s: float = 120.0) -> Engine:
    """Open the engine that the options describe; see `open_engine`.

    Raises:
        InvalidValueError: If an option is not allowed.
        EngineError: If Ray is not installed or refuses.
    """
    return open_engine(
        args.engine,
        args.address,
        args.workers,
        niceness=niceness,
        hang_timeout_s=hang_timeout_s,
    )
