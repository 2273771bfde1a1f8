"""``singulate dataset``: reward maps of many scenes, to learn from."""

import argparse
import json
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

from singulate.cli.engine_options import add_engine_options, engine_of
from singulate.cli.progress import CountBar
from singulate.cli.targets import check_directory_target
from singulate.datasets.building import build_dataset, plan_dataset
from singulate.datasets.manifest import DatasetConfig
from singulate.rewards import REWARDS

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "reward maps of many scenes, to learn from"
    parser = subparsers.add_parser(
        "dataset",
        help=text,
        description=f"{text}; run it again to go on where it was interrupted",
    )
    parser.add_argument("--scenes", type=int, default=1000, help="how many (%(default)s)")
    parser.add_argument("--scenario", default="random-2", help="such as random-3 (%(default)s)")
    parser.add_argument("--seed", type=int, default=0, help="decides the scenes (%(default)s)")
    parser.add_argument(
        "--resolution", type=int, default=64, help="starts along each side (%(default)s)"
    )
    parser.add_argument("--reward", default="paper", help=f"{', '.join(REWARDS)} (%(default)s)")
    parser.add_argument(
        "--goal-separation", type=float, default=0.1, metavar="M", help="[m] (%(default)s)"
    )
    parser.add_argument("--shard-size", type=int, default=128, help="scenes a file (%(default)s)")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="where to put it")
    add_engine_options(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    config = DatasetConfig(
        scenario=args.scenario,
        num_scenes=args.scenes,
        seed=args.seed,
        resolution=args.resolution,
        reward=args.reward,
        goal_separation=args.goal_separation,
        shard_size=args.shard_size,
    )
    check_directory_target("out", args.out)
    manifest, damaged = plan_dataset(config, args.out)
    for name in damaged:
        print(f"{args.out / name}: damaged, it is built again", file=sys.stderr)
    num_kept = sum(entry.num_scenes for entry in manifest.shards.values())
    began = time.monotonic()
    if not manifest.is_complete:
        with engine_of(args, niceness=5) as engine, CountBar("Scenes", args.scenes) as bar:
            manifest = build_dataset(manifest, args.out, engine, on_progress=bar.set)
    seconds = time.monotonic() - began
    size = sum(entry.size for entry in manifest.shards.values())
    if args.json:
        result = {"out": str(args.out), "sha256": manifest.sha256, "num_bytes": size}
        scenes = {"num_scenes": config.num_scenes, "num_kept": num_kept, "damaged": damaged}
        print(json.dumps({**result, **scenes, "seconds": round(seconds, 3)}))
    else:
        print(
            f"{config.num_scenes:,} scenes in {args.out}, {size / 1e6:.1f} MB; "
            f"{config.num_scenes - num_kept:,} built now in {seconds:.0f} s\n"
            f"SHA-256 {manifest.sha256}"
        )
    return 0
