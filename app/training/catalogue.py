"""What there is to load and to watch."""

from pathlib import Path

from app.policy_label import policy_label
from singulate.checkpoints.reading import read_manifest
from singulate.exceptions import SingulateError
from singulate.runs.listing import RunSummary, list_runs

MAX_RUNS = 50
FOLLOWED = ("Newest of the watched run", "run")
"""Entry that follows the watched run's checkpoints."""


def find_runs(runs_dir: Path) -> list[RunSummary]:
    """Runs, newest first; a directory that cannot be read counts as empty."""
    try:
        return list_runs(runs_dir)[:MAX_RUNS]
    except SingulateError:
        return []


def find_policies(checkpoints_dir: Path, *, is_watching: bool) -> tuple[tuple[str, str], ...]:
    """Policies that can be loaded: (label, source), by name.

    Args:
        checkpoints_dir: Holds checkpoint directories.
        is_watching: Whether a run is watched, whose newest policy can then be followed.
    """
    found = []
    if checkpoints_dir.is_dir():
        for path in sorted(checkpoints_dir.iterdir()):
            label = _label(path)
            if label is not None:
                found.append((label, str(path)))
    if is_watching:
        found.append(FOLLOWED)
    return tuple(found)


def _label(path: Path) -> str | None:
    try:
        return policy_label(path, read_manifest(path).step)
    except SingulateError:
        return None
