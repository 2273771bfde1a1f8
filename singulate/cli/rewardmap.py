"""``singulate rewardmap``: the true reward of every push on one scene, as a file."""

import argparse
import json
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

from singulate.cli.engine_options import add_engine_options, engine_of
from singulate.cli.targets import check_file_target
from singulate.engine import Engine
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Poses, Workspace, standing_pose
from singulate.rewardmap import RewardMap, RewardMapRequest, compute_reward_map
from singulate.rewards import REWARDS
from singulate.simulation import make_scenario

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "true reward of every push on a scene, by real simulated pushes"
    parser = subparsers.add_parser("rewardmap", help=text, description=text)
    parser.add_argument("--scenario", default="random-2", help="such as random-3 (%(default)s)")
    parser.add_argument("--seed", type=int, default=0, help="decides the scene (%(default)s)")
    parser.add_argument(
        "--out",
        type=Path,
        metavar="FILE",
        help="write an .npz; its reward_map is float32 (4, H, W): up, right, down, left",
    )
    parser.add_argument(
        "--resolution", type=int, default=64, help="starts along each side (%(default)s)"
    )
    parser.add_argument("--reward", default="paper", help=f"{', '.join(REWARDS)} (%(default)s)")
    parser.add_argument(
        "--goal-separation", type=float, default=0.1, metavar="M", help="[m] (%(default)s)"
    )
    parser.add_argument(
        "--exact", action="store_true", help="execute every push, also those that move nothing"
    )
    add_engine_options(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    request = RewardMapRequest(
        poses=_scene(args.scenario, args.seed),
        resolution=args.resolution,
        goal_separation=args.goal_separation,
        reward=args.reward,
        exact=args.exact,
    )
    if args.out is not None:
        check_file_target("out", args.out)
    with engine_of(args) as engine:
        began = time.monotonic()
        reward_map = _compute(request, engine, is_quiet=args.json)
        seconds = time.monotonic() - began
    if args.out is not None:
        reward_map.save_npz(args.out)
    result = {
        "scenario": args.scenario,
        "seed": args.seed,
        "resolution": args.resolution,
        "seconds": round(seconds, 3),
        "out": str(args.out) if args.out else None,
        "best": [_best(reward_map, direction) for direction in Direction],
    }
    if args.json:
        print(json.dumps(result))
    else:
        _print_text(result)
    return 0


def _scene(scenario: str, seed: int) -> Poses:
    """The blocks that the environment puts up for this seed."""
    if seed < 0:
        raise InvalidValueError("seed", seed, "an integer of at least 0")
    layout = make_scenario(scenario).sample(np.random.default_rng(seed), Workspace())
    return tuple(standing_pose(block) for block in layout)


def _compute(request: RewardMapRequest, engine: Engine, is_quiet: bool) -> RewardMap:
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TaskProgressColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), disable=is_quiet) as progress:
        bar = progress.add_task("coarse map", total=1.0)

        def show(reward_map: RewardMap) -> None:
            size = reward_map.resolution
            progress.update(
                bar, completed=reward_map.progress, description=f"{size} x {size} starts"
            )

        return compute_reward_map(request, engine, on_progress=show)


def _best(reward_map: RewardMap, direction: Direction) -> dict[str, Any]:
    values = reward_map.values[direction]
    row, col = np.unravel_index(int(values.argmax()), values.shape)
    x, y = Workspace().row_col_to_xy(int(row), int(col), reward_map.resolution)
    reward = round(float(values[row, col]), 3)
    return {"direction": direction.label, "start": [x, y], "reward": reward}


def _print_text(result: dict[str, Any]) -> None:
    for best in result["best"]:
        x, y = best["start"]
        print(f"best push {best['direction']:>5}: {best['reward']:8.1f} from ({x:.3f}, {y:.3f}) m")
    print(f"{result['seconds']:.1f} s" + (f", written to {result['out']}" if result["out"] else ""))
