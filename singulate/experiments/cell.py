"""One cell of an experiment: a training, and how good its agent is on unseen scenes."""

import hashlib
import json
import shutil
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.exceptions import ResumeError, RunError
from singulate.runs import RunDirectory
from singulate.runs.lock import lock_holder
from singulate.training.config import TrainingConfig

if TYPE_CHECKING:
    from singulate.training.trainer import TrainingResult

LOCK_PATIENCE_S = 60.0
"""How long the workers of a node that is gone may take to notice it [s]."""


@dataclass(frozen=True)
class Cell:
    """What decides a cell's result; equal cells have equal results.

    Attributes:
        training: The training.
        episodes: Episodes of its evaluation.
        evaluation_seed: Decides the scenes of the evaluation.
        autoencoder: What the agent looks through, trained before the first cell that needs it; None
            for an agent that sees the observation itself, or has another `encoder` set.
        settings: What was set for this cell, by name, to tell it apart from others; all of it is
            in `training` already.
    """

    training: TrainingConfig
    episodes: int = 1000
    evaluation_seed: int = 7
    autoencoder: AutoencoderConfig | None = field(default=None, kw_only=True)
    settings: Mapping[str, Any] = field(default_factory=dict, compare=False)

    @property
    def key(self) -> str:
        """Hash of what decides the result."""
        content: list[Any] = [self.training.to_dict(), self.episodes, self.evaluation_seed]
        if self.autoencoder is not None:
            content.append(asdict(self.autoencoder))
        return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:16]

    @property
    def name(self) -> str:
        """Name of its directory."""
        config = self.training
        return f"{config.agent}-{config.env.scenario}-seed{config.seed}-{self.key}"


@dataclass(frozen=True)
class CellResult:
    """What became of a cell.

    Attributes:
        weights_sha256: Hash of the trained weights.
        num_steps: Pushes of the training.
        num_successes: Successful episodes of the evaluation.
        num_episodes: All of its episodes.
        mean_reward: Mean sum of rewards of an episode.
        mean_pushes: Mean number of pushes of an episode.
    """

    weights_sha256: str
    num_steps: int
    num_successes: int
    num_episodes: int
    mean_reward: float
    mean_pushes: float

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """The inverse of `to_dict`.

        Raises:
            TypeError: If a value is missing or unknown.
        """
        return cls(**values)


class CellTask(NamedTuple):
    """A cell, and where its run and its autoencoder lie; a task of an engine."""

    cell: Cell
    run_dir: str
    autoencoder_dir: str | None = None


def run_cell(_tool: object, task: CellTask) -> CellResult:
    """Train, or go on where a training was interrupted, and evaluate.

    Raises:
        CheckpointError: If the autoencoder or a checkpoint cannot be written.
        RunError: If somebody stopped the training, or another process does not let go of it.
    """
    from singulate.agents.loading import load_policy
    from singulate.checkpoints.reading import read_manifest
    from singulate.checkpoints.saving import WEIGHTS_NAME
    from singulate.evaluation import evaluate

    cell = task.cell
    trained = _train(_training_of(task), Path(task.run_dir))
    if trained.state != "finished":
        raise RunError(f"{task.run_dir}: stopped after {trained.progress.num_steps} pushes")
    policy = load_policy(trained.checkpoint)
    evaluation = evaluate(policy, cell.training.env, cell.episodes, cell.evaluation_seed)
    return CellResult(
        weights_sha256=read_manifest(trained.checkpoint).files[WEIGHTS_NAME].sha256,
        num_steps=trained.progress.num_steps,
        num_successes=evaluation.num_successes,
        num_episodes=evaluation.num_episodes,
        mean_reward=evaluation.mean_reward,
        mean_pushes=evaluation.mean_pushes,
    )


def _training_of(task: CellTask) -> TrainingConfig:
    """The cell's training, with the place of its autoencoder filled in."""
    from singulate.experiments.shared_autoencoder import ensure_autoencoder

    training, autoencoder = task.cell.training, task.cell.autoencoder
    if autoencoder is None or task.autoencoder_dir is None:
        return training
    directory = ensure_autoencoder(autoencoder, Path(task.autoencoder_dir))
    return replace(training, agent_config={**training.agent_config, "encoder": str(directory)})


def _train(config: TrainingConfig, run_dir: Path) -> "TrainingResult":
    from singulate.training.trainer import train

    _wait_for_lock(run_dir)
    if not RunDirectory(run_dir).config_path.exists():
        shutil.rmtree(run_dir, ignore_errors=True)
        return train(config, run_dir, on_trouble=_give_up)
    try:
        return train(config, run_dir, resume=True, on_trouble=_give_up)
    except ResumeError:
        shutil.rmtree(run_dir)
        return train(config, run_dir, on_trouble=_give_up)


def _give_up(reason: str) -> None:
    """Nobody is there to make room and to resume a cell."""
    raise RunError(reason)


def _wait_for_lock(run_dir: Path) -> None:
    give_up = time.monotonic() + LOCK_PATIENCE_S
    while lock_holder(run_dir) is not None and time.monotonic() < give_up:
        time.sleep(0.1)
