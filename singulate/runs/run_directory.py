"""Where everything of one training run lies."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from singulate.checkpoints import checkpoint_name, latest_checkpoint
from singulate.checkpoints.durable import replace_file
from singulate.exceptions import RunError
from singulate.runs.json_text import parse_json_object

LAUNCH_FILES = frozenset({"trainer.log", "launch.json", "lock"})
"""What whoever starts a trainer may have put there before the run exists."""


@dataclass(frozen=True)
class RunDirectory:
    """The layout of a run directory.

    Attributes:
        path: The directory; it need not exist.
    """

    path: Path

    @property
    def config_path(self) -> Path:
        """The resolved configuration, JSON."""
        return self.path / "config.json"

    @property
    def status_path(self) -> Path:
        """What the trainer last said about itself, JSON."""
        return self.path / "status.json"

    @property
    def record_path(self) -> Path:
        """Metrics, pushes and events, SQLite."""
        return self.path / "record.sqlite"

    @property
    def control_path(self) -> Path:
        """Directory of messages to the trainer."""
        return self.path / "control"

    @property
    def checkpoints_path(self) -> Path:
        """Directory of checkpoints."""
        return self.path / "checkpoints"

    @property
    def tensorboard_path(self) -> Path:
        """Directory of TensorBoard event files."""
        return self.path / "tensorboard"

    @property
    def lock_path(self) -> Path:
        """File that the trainer keeps locked while it lives."""
        return self.path / "lock"

    @property
    def log_path(self) -> Path:
        """What the trainer wrote to its standard error."""
        return self.path / "trainer.log"

    def checkpoint_path(self, step: int) -> Path:
        """Directory of the checkpoint after this many training steps."""
        return self.checkpoints_path / checkpoint_name(step)

    def latest_checkpoint(self) -> Path | None:
        """The newest checkpoint that verifies; None where there is none."""
        return latest_checkpoint(self.checkpoints_path)

    def create(self, config: Mapping[str, Any]) -> Self:
        """Make the directory of a new run.

        Args:
            config: The resolved configuration, plain JSON values.

        Raises:
            RunError: If there is a run already, other files are in the directory, or it is not
                writable.
        """
        try:
            text = json.dumps(config, indent=2, allow_nan=False) + "\n"
        except (TypeError, ValueError) as error:
            raise RunError(f"{self.path}: the configuration is not plain JSON: {error}") from error
        try:
            self.path.mkdir(parents=True, exist_ok=True)
            if self.config_path.exists():
                raise RunError(f"{self.path}: holds a run already; resume it or choose another")
            foreign = sorted(p.name for p in self.path.iterdir() if p.name not in LAUNCH_FILES)
            if foreign:
                raise RunError(f"{self.path}: is not empty, it holds {foreign[0]!r}")
            self.control_path.mkdir()
            self.checkpoints_path.mkdir()
            self.tensorboard_path.mkdir()
            self.lock_path.touch()
            replace_file(self.config_path, text.encode())
        except OSError as error:
            raise RunError(
                f"{self.path}: cannot be created or written ({error.strerror or error})"
            ) from error
        return self

    def open(self) -> Self:
        """Check that a run is there.

        Raises:
            RunError: If not.
        """
        if not self.path.is_dir():
            raise RunError(f"{self.path}: there is no such run directory")
        if not self.is_run:
            raise RunError(f"{self.path}: not a run directory, it has no config.json and lock")
        return self

    @property
    def is_run(self) -> bool:
        """Whether a run is there."""
        return self.config_path.is_file() and self.lock_path.is_file()

    def read_config(self) -> dict[str, Any]:
        """The configuration that the run was created, or last resumed, with.

        Raises:
            RunError: If it is missing or damaged.
        """
        try:
            return parse_json_object(self.config_path.read_bytes())
        except (OSError, ValueError) as error:
            raise RunError(f"{self.config_path}: cannot be read ({error})") from error
