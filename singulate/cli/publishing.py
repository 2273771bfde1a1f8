"""Makes a small checkpoint to give away out of a run: weights, manifest and a README."""

import json
import shlex
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from singulate.agents.registry import agent_kind
from singulate.checkpoints import read_checkpoint, save_checkpoint
from singulate.envs import EnvConfig
from singulate.exceptions import CheckpointError, RunError
from singulate.runs import RunDirectory
from singulate.training.config import TrainingConfig

if TYPE_CHECKING:
    from singulate.evaluation import Evaluation

_ENV_OPTIONS = ("observation", "action", "reward", "max_pushes", "goal_separation")
_OFFLINE_ENV_OPTIONS = ("observation", "action")
"""The rest of the task is the data set's."""

README = """# {name}

A `{agent}` agent for `{scenario}`, {steps:,} pushes of training.

| over {episodes:,} episodes | success | 95 % interval | mean reward | failures |
|---|---|---|---|---|
{rows}

Trained with{stopped}

    {train_command}

and measured (goal {goal:g} m, at most {max_pushes} push{plural} an episode) with

    {evaluate_command}

The scenes are drawn with seeds that no training uses (a `fixed` scenario has one scene only).

Load it with `singulate.load_policy("{directory}")`. It holds weights alone: to train
further, train anew with the command above.
"""


def publish(source: Path, directory: Path, measured: Mapping[str, "Evaluation"], seed: int) -> Path:
    """Copy a run's checkpoint without its training state, with a README of what was measured.

    Args:
        source: A checkpoint in a run's ``checkpoints`` directory.
        directory: Where the copy goes; an earlier copy is replaced.
        measured: How it did on its own task in different ways, and how others did, by name.
        seed: Seed of all evaluations.

    Returns:
        `directory`.

    Raises:
        CheckpointError: If the source is not part of a run, or the copy cannot be written.
    """
    config = run_config(source)
    checkpoint = read_checkpoint(source, with_files=False)
    notes = {
        "seed": config.seed,
        "command": train_command(config),
        "evaluation_seed": seed,
        "measured": {name: evaluation.to_dict() for name, evaluation in measured.items()},
    }
    readme = _readme(directory, config, checkpoint.manifest.step, measured, seed)
    manifest = replace(checkpoint.manifest, notes=notes)
    return save_checkpoint(directory, checkpoint.tensors, manifest, {"README.md": readme.encode()})


def run_config(source: Path) -> TrainingConfig:
    """Settings of the run that a checkpoint is part of.

    Raises:
        CheckpointError: If it is not part of a run.
    """
    try:
        values = RunDirectory(source.resolve().parent.parent).open().read_config()
    except RunError as error:
        raise CheckpointError(f"{source}: only a run's checkpoint can be published") from error
    return TrainingConfig.from_dict(values)


def train_command(config: TrainingConfig) -> str:
    """The command line that trains the same agent again."""
    words = ["singulate train", f"--agent {config.agent}"]
    if config.dataset is None:
        words.append(f"--scenario {config.env.scenario}")
    else:
        words.append(f"--dataset {shlex.quote(config.dataset)}")
    words += [f"--steps {config.total_timesteps}", f"--seed {config.seed}"]
    if config.num_envs > 1:
        words.append(f"--envs {config.num_envs}")
    plain = EnvConfig(config.env.scenario, action=agent_kind(config.agent).actions[0])
    for name in _ENV_OPTIONS if config.dataset is None else _OFFLINE_ENV_OPTIONS:
        value = getattr(config.env, name)
        if value != getattr(plain, name):
            words.append(f"--{name.replace('_', '-')} {value}")
    plain_agent = TrainingConfig(config.agent, config.env, 1).agent_config
    for name, value in config.agent_config.items():
        if value != plain_agent.get(name):
            words.append(f"--set {shlex.quote(f'{name}={_as_typed(value)}')}")
    return " ".join(words)


def _as_typed(value: object) -> str:
    return value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))


def _readme(
    directory: Path,
    config: TrainingConfig,
    steps: int,
    measured: Mapping[str, "Evaluation"],
    seed: int,
) -> str:
    episodes = next(iter(measured.values())).num_episodes
    max_pushes = config.env.push_limit
    is_stopped = steps < config.total_timesteps
    return README.format(
        name=directory.name,
        directory=directory.as_posix(),
        stopped=f", of which this is the checkpoint after {steps:,} pushes" if is_stopped else "",
        agent=config.agent,
        scenario=config.env.scenario,
        steps=steps,
        episodes=episodes,
        rows="\n".join(_row(label, evaluation) for label, evaluation in measured.items()),
        train_command=train_command(config),
        goal=config.env.goal_separation,
        max_pushes=max_pushes,
        plural="" if max_pushes == 1 else "es",
        evaluate_command=f"singulate evaluate {directory.as_posix()} --episodes {episodes} "
        f"--seed {seed}",
    )


def _row(label: str, evaluation: "Evaluation") -> str:
    low, high = evaluation.success_interval
    failures = ", ".join(f"{kind} {count}" for kind, count in evaluation.failures.items())
    return (
        f"| {label} | {evaluation.success_rate:.1%} | {low:.1%} to {high:.1%} | "
        f"{evaluation.mean_reward:.0f} | {failures or 'none'} |"
    )
