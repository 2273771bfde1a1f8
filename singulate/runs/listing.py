"""All runs of a directory."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from singulate.exceptions import RunError
from singulate.runs.run_directory import RunDirectory
from singulate.runs.status import RunStatus, read_status


@dataclass(frozen=True)
class RunSummary:
    """What a list of runs shows.

    Attributes:
        path: The run's directory.
        config: Its configuration; empty where it is damaged.
        status: Its state; None where it is damaged.
        problem: What is damaged, one line; empty otherwise.
    """

    path: Path
    config: dict[str, Any]
    status: RunStatus | None
    problem: str = ""

    @property
    def name(self) -> str:
        """Name of the directory."""
        return self.path.name


def summarise_run(run_dir: Path) -> RunSummary:
    """Configuration and state of a run, damage included.

    Raises:
        RunError: If there is no run.
    """
    run = RunDirectory(run_dir).open()
    config: dict[str, Any] = {}
    try:
        config = run.read_config()
        return RunSummary(run_dir, config, read_status(run_dir))
    except RunError as error:
        return RunSummary(run_dir, config, None, str(error))


def list_runs(directory: Path) -> list[RunSummary]:
    """Runs directly inside a directory, newest first.

    Args:
        directory: For example `singulate.paths.default_runs_directory`; missing is no error.

    Raises:
        RunError: If it cannot be read.
    """
    if not directory.exists():
        return []
    try:
        runs = [run for run in map(RunDirectory, directory.iterdir()) if run.is_run]
        runs.sort(key=lambda run: (run.config_path.stat().st_mtime, run.path.name), reverse=True)
    except OSError as error:
        raise RunError(f"{directory}: cannot be read ({error.strerror or error})") from error
    return [summarise_run(run.path) for run in runs]
