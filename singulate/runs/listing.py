"""All runs of a directory."""

from contextlib import suppress
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
    """Runs directly inside a directory, newest first; one that is just being deleted is left out.

    Args:
        directory: For example `singulate.paths.default_runs_directory`; missing is no error.

    Raises:
        RunError: If it cannot be read.
    """
    if not directory.exists():
        return []
    try:
        paths = [path for path in directory.iterdir() if not path.name.startswith(".")]
    except OSError as error:
        raise RunError(f"{directory}: cannot be read ({error.strerror or error})") from error
    found = []
    for path in paths:
        with suppress(OSError, RunError):
            created = RunDirectory(path).config_path.stat().st_mtime
            found.append((created, path.name, summarise_run(path)))
    found.sort(key=lambda run: run[:2], reverse=True)
    return [summary for *_, summary in found]
