"""``singulate train``: train an agent, or continue a run."""

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from singulate.agents.registry import AGENTS, agent_kind
from singulate.checkpoints.reading import read_manifest
from singulate.cli.lists import parse_setting
from singulate.cli.progress import TrainingBar
from singulate.envs import ACTION_ENCODINGS, OBSERVATIONS, EnvConfig
from singulate.exceptions import InvalidValueError, SingulateError
from singulate.paths import default_runs_directory
from singulate.rewards import REWARDS
from singulate.runs import RunDirectory, new_run_directory
from singulate.runs.json_text import parse_json_object
from singulate.training.config import TrainingConfig

if TYPE_CHECKING:
    from singulate.training.trainer import TrainingResult

    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DEFAULT_STEPS = 20_000
NEW_RUN_OPTIONS = (
    "agent", "scenario", "seed", "observation", "action", "reward", "max_pushes",
    "goal_separation", "checkpoint_every", "envs", "threads",
    "settings", "dataset",
)  # fmt: skip
"""Options that describe a new run, so they fit neither ``--config`` nor ``--resume``."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add the command to a parser."""
    text = "train an agent"
    parser = subparsers.add_parser("train", help=text, description=text)
    parser.add_argument("--agent", help=f"of a new run: {', '.join(AGENTS)}")
    parser.add_argument("--scenario", help="such as fixed-2, random-3, cluster-5 (random-2)")
    parser.add_argument(
        "--steps",
        type=int,
        help=f"pushes in all; PPO and its kin finish their last rollout ({DEFAULT_STEPS})",
    )
    parser.add_argument("--seed", type=int, help="decides everything random (0)")
    parser.add_argument("--observation", help=", ".join(OBSERVATIONS))
    parser.add_argument("--action", help=", ".join(ACTION_ENCODINGS))
    parser.add_argument("--reward", help=", ".join(REWARDS))
    parser.add_argument("--max-pushes", type=int, help="pushes an episode may take")
    parser.add_argument("--goal-separation", type=float, metavar="M", help="d_goal of Eq. 2 [m]")
    parser.add_argument(
        "--dataset", type=Path, metavar="DIR", help="learn from a data set, without simulating"
    )
    parser.add_argument("--envs", type=int, metavar="N", help="environments at the same time (1)")
    parser.add_argument(
        "--workers", type=int, metavar="N", help="processes for several of them (one a core)"
    )
    parser.add_argument("--threads", type=int, metavar="N", help="threads of torch (1)")
    parser.add_argument("--checkpoint-every", type=int, metavar="N", help="pushes between them")
    parser.add_argument(
        "--set",
        dest="settings",
        action="append",
        metavar="KEY=VALUE",
        help="a setting of the agent, such as learning_rate=0.001; all: singulate agents AGENT",
    )
    parser.add_argument("--run-dir", type=Path, metavar="D", help="directory of a new run")
    parser.add_argument("--resume", type=Path, metavar="D", help="continue this run")
    parser.add_argument("--config", type=Path, metavar="FILE", help="all settings, as JSON")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    config, run_dir = _resolve(args)
    from singulate.training.trainer import train

    with TrainingBar(config.total_timesteps) as bar:
        result = train(
            config,
            run_dir,
            resume=args.resume is not None,
            on_progress=bar.update,
            on_trouble=lambda reason: print(_waiting(run_dir, reason), file=sys.stderr),
        )
    if args.json:
        print(json.dumps(_summary(result)))
    else:
        print(_text(result))
    return 130 if result.was_interrupted else 0


def _resolve(args: argparse.Namespace) -> tuple[TrainingConfig, Path]:
    """The run's settings and directory; see `train`."""
    if args.resume is not None:
        _refuse(args, (*NEW_RUN_OPTIONS, "run_dir", "config"), "--resume")
        run = RunDirectory(args.resume).open()
        values = run.read_config()
        if args.steps is not None:
            _check_goes_on(args.steps, run)
            values["total_timesteps"] = args.steps
        if args.workers is not None:
            values["num_workers"] = args.workers
        return TrainingConfig.from_dict(values), args.resume
    config = _config_of_file(args) if args.config is not None else _config_of_options(args)
    return config, args.run_dir or _new_run_dir(config)


def _check_goes_on(steps: int, run: RunDirectory) -> None:
    newest = run.latest_checkpoint()
    num_done = read_manifest(newest).step if newest is not None else 0
    if steps < num_done:
        raise InvalidValueError("--steps", steps, f"{num_done} or more, which are done already")


def _refuse(args: argparse.Namespace, names: tuple[str, ...], beside: str) -> None:
    for name in names:
        value = getattr(args, name)
        if value is not None:
            option = "--set" if name == "settings" else "--" + name.replace("_", "-")
            raise InvalidValueError(option, value, f"nothing beside {beside}")


def _config_of_file(args: argparse.Namespace) -> TrainingConfig:
    _refuse(args, (*NEW_RUN_OPTIONS, "steps", "workers"), "--config")
    try:
        values = parse_json_object(args.config.read_bytes())
    except ValueError as error:
        raise InvalidValueError("config", str(args.config), f"a JSON object ({error})") from None
    return TrainingConfig.from_dict(values)


def _config_of_options(args: argparse.Namespace) -> TrainingConfig:
    if args.agent is None:
        raise SingulateError(f"--agent is missing: one of {', '.join(AGENTS)}")
    kind = agent_kind(args.agent)
    action = args.action or kind.actions[0]
    given: dict[str, Any] = {
        "seed": args.seed,
        "checkpoint_every": args.checkpoint_every,
        "num_envs": args.envs,
        "num_workers": args.workers,
        "num_threads": args.threads,
    }
    if args.dataset is not None:
        env, origin = _env_of_dataset(args, action)
        given |= origin
    else:
        names = ("scenario", "observation", "reward", "max_pushes", "goal_separation")
        values = {name: getattr(args, name) for name in names}
        values = {name: value for name, value in values.items() if value is not None}
        env = EnvConfig.from_dict(values | {"action": action})
    return TrainingConfig(
        agent=kind.name,
        env=env,
        total_timesteps=DEFAULT_STEPS if args.steps is None else args.steps,
        agent_config=dict(parse_setting("--set", text) for text in args.settings or []),
        **{name: value for name, value in given.items() if value is not None},
    )


def _env_of_dataset(args: argparse.Namespace, action: str) -> tuple[EnvConfig, dict[str, str]]:
    """The task of a data set, and what the run's settings say of it."""
    _refuse(args, ("scenario", "reward", "max_pushes", "goal_separation"), "--dataset")
    from singulate.datasets import RecordedScenes
    from singulate.datasets.recorded_env import recorded_env_config

    scenes = RecordedScenes(args.dataset)
    env = recorded_env_config(scenes, args.observation or EnvConfig().observation, action)
    path = str(args.dataset.resolve())
    return env, {"dataset": path, "dataset_sha256": scenes.manifest.sha256}


def _new_run_dir(config: TrainingConfig) -> Path:
    directory = new_run_directory(default_runs_directory(), config.agent, config.env.scenario)
    print(f"Run directory: {directory}", file=sys.stderr)
    return directory


def _waiting(run_dir: Path, reason: str) -> str:
    return (
        f"singulate: waiting: {reason}; once that is put right, "
        f"singulate runs resume {run_dir} lets it go on"
    )


def _summary(result: "TrainingResult") -> dict[str, Any]:
    progress = result.progress
    return {
        "run_dir": str(result.run_dir),
        "state": result.state,
        "checkpoint": str(result.checkpoint),
        "num_steps": progress.num_steps,
        "recent_episodes": progress.num_episodes,
        "recent_success_rate": progress.success_rate if progress.num_episodes else None,
        "recent_mean_reward": progress.mean_reward if progress.num_episodes else None,
    }


def _text(result: "TrainingResult") -> str:
    progress = result.progress
    learning = (
        f"; while exploring, the last {progress.num_episodes:,} episodes had "
        f"{progress.success_rate:.1%} success and a mean reward of {progress.mean_reward:.0f}"
    )
    return (
        f"{result.state.capitalize()} after {progress.num_steps:,} pushes"
        f"{learning if progress.num_episodes else ', none of them now'}.\n"
        f"Checkpoint: {result.checkpoint}\n"
        f"Measure it: singulate evaluate {result.checkpoint}"
    )
