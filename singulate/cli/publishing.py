"""Makes a small checkpoint to give away out of a run: weights, manifest and a README."""

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from singulate.agents.registry import agent_kind
from singulate.checkpoints import read_checkpoint, save_checkpoint
from singulate.envs import EnvConfig
from singulate.evaluation import Evaluation
from singulate.exceptions import CheckpointError, RunError
from singulate.runs import RunDirectory
from singulate.training.config import TrainingConfig

README = """# {name}

A {agent} for `{scenario}`, {steps:,} pushes of training.

| on {episodes:,} unseen scenes | success | 95 % interval | mean reward | failures |
|---|---|---|---|---|
| **this checkpoint** | {agent_row} |
| random pushes | {random_row} |

Trained with

    {train_command}

and measured (goal {goal:g} m, at most {max_pushes} push{plural} an episode) with

    {evaluate_command}

Load it: `singulate.load_policy("checkpoints/{name}")`. It holds weights alone; to train further,
train anew with the command above.
"""


def publish(
    source: Path, directory: Path, evaluation: Evaluation, baseline: Evaluation, seed: int
) -> Path:
    """Copy a run's checkpoint without its training state, with a README of what was measured.

    Args:
        source: A checkpoint in a run's ``checkpoints`` directory.
        directory: Where the copy goes; an earlier copy is replaced.
        evaluation: How it did on its own task.
        baseline: How the random policy did on the same scenes.
        seed: Seed of both evaluations.

    Returns:
        `directory`.

    Raises:
        CheckpointError: If the source is not part of a run, or the copy cannot be written.
    """
    try:
        run_config = RunDirectory(source.resolve().parent.parent).open().read_config()
    except RunError as error:
        raise CheckpointError(f"{source}: only a run's checkpoint can be published") from error
    config = TrainingConfig.from_dict(run_config)
    checkpoint = read_checkpoint(source, with_files=False)
    notes = {
        "seed": config.seed,
        "command": train_command(config),
        "evaluation": {"seed": seed, **evaluation.to_dict()},
        "random_policy": {"seed": seed, **baseline.to_dict()},
    }
    readme = _readme(directory.name, config, checkpoint.manifest.step, notes, evaluation, baseline)
    manifest = replace(checkpoint.manifest, notes=notes)
    return save_checkpoint(directory, checkpoint.tensors, manifest, {"README.md": readme.encode()})


def train_command(config: TrainingConfig) -> str:
    """The command line that trains the same agent again."""
    words = ["singulate train", f"--agent {config.agent}", f"--scenario {config.env.scenario}"]
    words += [f"--steps {config.total_timesteps}", f"--seed {config.seed}"]
    plain = EnvConfig(config.env.scenario, action=agent_kind(config.agent).actions[0])
    for field in fields(EnvConfig):
        value = getattr(config.env, field.name)
        if value != getattr(plain, field.name):
            words.append(f"--{field.name.replace('_', '-')} {value}")
    plain_agent = TrainingConfig(config.agent, config.env, 1).agent_config
    for name, value in config.agent_config.items():
        if value != plain_agent[name]:
            words.append(f"--set {name}={str(value).replace(' ', '')}")
    return " ".join(words)


def _readme(
    name: str,
    config: TrainingConfig,
    steps: int,
    notes: dict[str, Any],
    evaluation: Evaluation,
    baseline: Evaluation,
) -> str:
    episodes, seed = evaluation.num_episodes, notes["evaluation"]["seed"]
    max_pushes = config.env.push_limit
    return README.format(
        name=name,
        agent=config.agent.upper(),
        scenario=config.env.scenario,
        steps=steps,
        episodes=episodes,
        agent_row=_row(evaluation),
        random_row=_row(baseline),
        train_command=notes["command"],
        goal=config.env.goal_separation,
        max_pushes=max_pushes,
        plural="" if max_pushes == 1 else "es",
        evaluate_command=f"singulate evaluate checkpoints/{name} --episodes {episodes} "
        f"--seed {seed}",
    )


def _row(evaluation: Evaluation) -> str:
    low, high = evaluation.success_interval
    failures = ", ".join(f"{kind} {count}" for kind, count in evaluation.failures.items())
    return (
        f"{evaluation.success_rate:.1%} | {low:.1%} to {high:.1%} | "
        f"{evaluation.mean_reward:.0f} | {failures or 'none'}"
    )
