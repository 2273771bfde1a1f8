"""``singulate evaluate``: how good an agent is on scenes that it has never seen."""

import argparse
import json
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

from singulate.agents.policy import Policy
from singulate.agents.random_policy import RandomPolicy
from singulate.cli.engine_options import add_engine_options, engine_of, needs_engine
from singulate.cli.progress import CountBar
from singulate.cli.publishing import publish, run_config
from singulate.cli.targets import check_checkpoint_target
from singulate.engine import Engine
from singulate.envs import EnvConfig
from singulate.evaluation.yardsticks import YARDSTICKS
from singulate.exceptions import InvalidValueError

if TYPE_CHECKING:
    from singulate.evaluation import Evaluation

    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

ACTING = {False: "greedy", True: "drawing"}
ENV_OPTIONS = ("scenario", "reward", "max_pushes", "goal_separation")


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "success and rewards of a trained agent on unseen scenes"
    parser = subparsers.add_parser("evaluate", help=text, description=text)
    parser.add_argument(
        "checkpoint",
        metavar="CHECKPOINT",
        help="a checkpoint, a run directory (its newest checkpoint), or a policy without "
        f"learning: {', '.join(YARDSTICKS)}",
    )
    parser.add_argument("--scenario", help="such as random-2 (the one it was trained on)")
    parser.add_argument("--episodes", type=int, default=1000, help="(%(default)s)")
    parser.add_argument("--seed", type=int, default=7, help="decides the scenes (%(default)s)")
    parser.add_argument("--reward", help="(the one it was trained on)")
    parser.add_argument("--max-pushes", type=int, help="pushes an episode may take")
    parser.add_argument("--goal-separation", type=float, metavar="M", help="d_goal of Eq. 2 [m]")
    acting = parser.add_mutually_exclusive_group()
    acting.add_argument(
        "--sample",
        action="store_true",
        default=None,
        help="draw pushes (PPO, TRPO and SAC do anyway); an agent of values takes now and then "
        "another one than the best",
    )
    acting.add_argument(
        "--greedy",
        dest="sample",
        action="store_false",
        default=None,
        help="the push of the highest value or density (all others do anyway)",
    )
    add_engine_options(parser)
    parser.add_argument(
        "--publish",
        type=Path,
        metavar="DIR",
        help="also copy the weights there, with a README of what was measured",
    )
    parser.add_argument(
        "--overwrite", action="store_true", help="replace a checkpoint that is there already"
    )
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    if args.publish is not None:
        _check_publishing(args)
    policy, source, env_config = _load(args.checkpoint)
    changes = {name: getattr(args, name) for name in ENV_OPTIONS}
    env_config = replace(env_config, **{k: v for k, v in changes.items() if v is not None})
    if args.publish is not None:
        run_config(Path(source))
    is_sampled = policy.is_random if args.sample is None else args.sample
    with engine_of(args, niceness=5) if needs_engine(args) else nullcontext() as engine:
        evaluation = _evaluate(args, engine, policy, env_config, is_sampled)
        if args.publish is not None:
            other = not is_sampled
            measured = {
                ACTING[is_sampled]: evaluation,
                ACTING[other]: _evaluate(args, engine, policy, env_config, other),
                "random pushes": _evaluate(args, engine, RandomPolicy(), env_config, True),
            }
            publish(Path(source), args.publish, measured, args.seed)
    about = {
        "checkpoint": source,
        "agent": policy.kind,
        "scenario": env_config.scenario,
        "reward": env_config.reward,
        "goal_separation": env_config.goal_separation,
        "max_pushes": env_config.push_limit,
        "is_sampled": is_sampled,
        "seed": args.seed,
    }
    if args.json:
        print(json.dumps({**about, **evaluation.to_dict()}))
    else:
        _print_text(about, evaluation)
        if args.publish is not None:
            print(f"Published: {args.publish}")
    return 0


def _check_publishing(args: argparse.Namespace) -> None:
    """What is published is measured on the agent's own task."""
    for name in ENV_OPTIONS:
        value = getattr(args, name)
        if value is not None:
            option = "--" + name.replace("_", "-")
            raise InvalidValueError(option, value, "nothing beside --publish")
    check_checkpoint_target("publish", args.publish, may_overwrite=args.overwrite)


def _evaluate(
    args: argparse.Namespace,
    engine: Engine | None,
    policy: Policy,
    env_config: EnvConfig,
    sample: bool,
) -> "Evaluation":
    from singulate.evaluation import evaluate

    with CountBar(f"Evaluating {policy.kind}", args.episodes) as bar:
        return evaluate(
            policy,
            env_config,
            args.episodes,
            args.seed,
            sample=sample,
            engine=engine,
            on_progress=bar.set,
        )


def _load(name: str) -> tuple[Policy, str, EnvConfig]:
    """A policy, where it is from, and the task it was trained on."""
    if name in YARDSTICKS:
        return YARDSTICKS[name](), name, EnvConfig()
    import torch

    from singulate.agents.loading import checkpoint_directory, policy_from_checkpoint
    from singulate.checkpoints import read_checkpoint

    if not Path(name).exists():
        raise InvalidValueError(
            "checkpoint", name, f"a directory, or one of {', '.join(YARDSTICKS)}"
        )
    torch.set_num_threads(1)  # small batches, push after push: a second thread mostly waits
    directory = checkpoint_directory(Path(name))
    checkpoint = read_checkpoint(directory, with_files=False)
    policy = policy_from_checkpoint(checkpoint)
    return policy, str(directory), EnvConfig.from_dict(checkpoint.manifest.env_config)


def _print_text(about: dict[str, Any], evaluation: "Evaluation") -> None:
    low, high = evaluation.success_interval
    console = Console()
    console.print(
        f"{about['checkpoint']} ({ACTING[about['is_sampled']]}) on {about['scenario']}, "
        f"{evaluation.num_episodes} episodes (seed {about['seed']}, "
        f"goal {about['goal_separation']:g} m)",
        highlight=False,
        soft_wrap=True,
    )
    table = Table(box=None, show_header=False)
    table.add_row(
        "success", f"{evaluation.success_rate:.1%}", f"95 % interval {low:.1%} to {high:.1%}"
    )
    terms = ", ".join(f"{k} {v:.1f}" for k, v in evaluation.mean_reward_by_term.items())
    table.add_row("mean reward", f"{evaluation.mean_reward:.1f}", terms)
    table.add_row("mean pushes", f"{evaluation.mean_pushes:.2f}", "")
    failures = ", ".join(f"{kind} {count}" for kind, count in evaluation.failures.items())
    num_failures = evaluation.num_episodes - evaluation.num_successes
    table.add_row("failures", str(num_failures), failures or "none")
    console.print(table)
