"""``singulate ceiling``: the share of scenes that some push of a grid solves."""

import argparse
import json
import time
from typing import TYPE_CHECKING

from singulate.cli.engine_options import add_engine_options, engine_of
from singulate.cli.progress import CountBar

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "share of scenes that some push of a grid solves, by exhaustive search"
    parser = subparsers.add_parser("ceiling", help=text, description=text)
    parser.add_argument("--scenario", default="random-2", help="such as random-3 (%(default)s)")
    parser.add_argument(
        "--grid",
        type=int,
        default=10,
        metavar="N",
        help="starts along each side, the centres of equal cells (%(default)s, the paper's)",
    )
    parser.add_argument("--scenes", type=int, default=1000, help="how many (%(default)s)")
    parser.add_argument(
        "--seed", type=int, default=7, help="decides the scenes, as in evaluate (%(default)s)"
    )
    parser.add_argument(
        "--goal-separation", type=float, default=0.1, metavar="M", help="[m] (%(default)s)"
    )
    add_engine_options(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    from singulate.experiments.ceiling import CeilingConfig, measure_ceiling

    config = CeilingConfig(
        args.scenario, args.grid, args.scenes, args.seed, goal_separation=args.goal_separation
    )
    began = time.monotonic()
    with engine_of(args, niceness=5) as engine, CountBar("Scenes", config.num_scenes) as bar:
        ceiling = measure_ceiling(config, engine, bar.set)
    seconds = time.monotonic() - began
    if args.json:
        about = {"scenario": config.scenario, "grid": config.grid, "seed": config.seed}
        goal = {"goal_separation": config.goal_separation}
        print(json.dumps({**about, **goal, **ceiling.to_dict(), "seconds": round(seconds, 1)}))
    else:
        low, high = ceiling.interval
        print(
            f"{config.scenario}, {config.grid} x {config.grid} starts, four directions: a push "
            f"solves {ceiling.share:.1%} of {config.num_scenes:,} scenes "
            f"(95 % interval {low:.1%} to {high:.1%}, seed {config.seed}, {seconds:.0f} s)"
        )
    return 0
