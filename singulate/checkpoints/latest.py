"""The checkpoints of a run, by training step."""

import re
import shutil
from functools import lru_cache
from pathlib import Path

from singulate.checkpoints.reading import read_manifest, verify_checkpoint
from singulate.exceptions import CheckpointError

NAME = re.compile(r"step-(\d{9,})")

Signature = tuple[tuple[str, int, int], ...]
"""Name, size and time of change of every file: equal as long as nobody wrote."""


def checkpoint_name(step: int) -> str:
    """Directory name of the checkpoint after this many training steps.

    >>> checkpoint_name(1000)
    'step-000001000'
    """
    return f"step-{step:09d}"


def list_checkpoints(directory: Path) -> list[Path]:
    """Checkpoint directories by training step, oldest first, not verified.

    Args:
        directory: A run's ``checkpoints``; empty or missing is no error.
    """
    if not directory.is_dir():
        return []
    matches = [(NAME.fullmatch(path.name), path) for path in directory.iterdir()]
    return [path for _, path in sorted((int(m[1]), path) for m, path in matches if m is not None)]


def latest_checkpoint(directory: Path) -> Path | None:
    """The newest checkpoint whose every file verifies; cheap to call again and again.

    Args:
        directory: A run's ``checkpoints``.

    Returns:
        Its directory; None where there is none.
    """
    for path in reversed(list_checkpoints(directory)):
        if _is_intact(path, _signature(path)):
            return path
    return None


def prune(directory: Path, num_kept: int) -> list[Path]:
    """Remove the oldest checkpoints.

    The newest one that verifies is kept in any case.

    Args:
        directory: A run's ``checkpoints``.
        num_kept: How many of the newest to keep, 1 or more.

    Returns:
        What was removed.
    """
    newest = latest_checkpoint(directory)
    removed = [path for path in list_checkpoints(directory)[: -max(num_kept, 1)] if path != newest]
    for path in removed:
        shutil.rmtree(path, ignore_errors=True)
    return removed


@lru_cache(maxsize=256)
def _is_intact(directory: Path, signature: Signature) -> bool:
    try:
        verify_checkpoint(directory)
    except CheckpointError:
        return False
    return bool(signature)


def _signature(directory: Path) -> Signature:
    try:
        names = ["manifest.json", *read_manifest(directory).files]
        stats = [(name, (directory / name).stat()) for name in names]
    except (CheckpointError, OSError):
        return ()
    return tuple((name, found.st_size, found.st_mtime_ns) for name, found in stats)
