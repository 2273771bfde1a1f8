"""A trainer that was started from the page.

A dashboard that ends in order asks it to save a checkpoint and stop; one that is killed leaves it
running, and the next dashboard finds it.
"""

import subprocess
from pathlib import Path
from typing import Self

import numpy as np

from app.snapshot import RunSnapshot
from singulate.training.config import TrainingConfig
from singulate.training.launcher import TrainerProcess, start_trainer


class Launched:
    """The process and the run directory that it is making.

    Args:
        trainer: The process.
        config: What it was asked to do; None where it goes on with a run.
    """

    def __init__(self, trainer: TrainerProcess, config: TrainingConfig | None = None) -> None:
        self._trainer = trainer
        self._config = config

    @classmethod
    def start(cls, config: TrainingConfig, run_dir: Path) -> Self:
        """Start a new run."""
        return cls(start_trainer(config, run_dir), config)

    @classmethod
    def resume(cls, run_dir: Path) -> Self:
        """Go on with a run from its last checkpoint."""
        return cls(start_trainer(None, run_dir))

    @property
    def run_dir(self) -> Path:
        """Where its run is."""
        return self._trainer.run_dir

    @property
    def pid(self) -> int:
        """Process id."""
        return self._trainer.process.pid

    @property
    def is_alive(self) -> bool:
        """Whether the process is there."""
        return self._trainer.process.poll() is None

    @property
    def death(self) -> str:
        """Why it ended, one line; empty while it lives or where it ended well."""
        return self._trainer.death() or ""

    def stop(self) -> None:
        """Have it save a checkpoint and end; one that has only begun ends at once."""
        if self.is_alive:
            self._trainer.process.terminate()

    def wait(self, timeout_s: float) -> bool:
        """Wait for its end; False if it is still there."""
        try:
            self._trainer.process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            return False
        return True

    def snapshot(self) -> RunSnapshot:
        """The run before its trainer has made its directory: starting, or failed."""
        is_alive = self.is_alive
        config = self._config
        return RunSnapshot(
            run_dir=str(self.run_dir),
            name=self.run_dir.name,
            agent=config.agent if config else "",
            scenario=config.env.scenario if config else "",
            state="starting" if is_alive else "failed",
            reason=self.death,
            num_steps=0,
            total_steps=config.total_timesteps if config else 0,
            pushes_per_second=0.0,
            eta_s=None,
            age_s=0.0,
            curves={},
            starts=np.zeros((0, 2), np.float32),
            start_steps=np.zeros(0, np.int64),
            last_checkpoint="",
            revision=0,
        )
