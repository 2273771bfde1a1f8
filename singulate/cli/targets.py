"""Finds out that something cannot be written there before it is computed."""

import tempfile
from pathlib import Path

from singulate.checkpoints import check_replaceable
from singulate.exceptions import InvalidValueError


def check_file_target(key: str, path: Path) -> None:
    """Check that a file can be put there.

    Raises:
        InvalidValueError: If it is a directory or a device, or its directory is missing or not
            writable.
    """
    if path.exists() and not path.is_file():
        what = "directory" if path.is_dir() else "device or a pipe"
        raise InvalidValueError(key, str(path), f"a file, this is a {what}")
    if not path.parent.is_dir():
        raise InvalidValueError(key, str(path), "a file in a directory that exists")
    _check_writable(key, path, path.parent)


def check_directory_target(key: str, path: Path) -> None:
    """Check that files can be put into a directory, which is made with its parents.

    Raises:
        InvalidValueError: If it is a file, or cannot be made or written.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        allowed = f"a directory that can be made ({error.strerror or error})"
        raise InvalidValueError(key, str(path), allowed) from None
    _check_writable(key, path, path)


def check_checkpoint_target(key: str, path: Path, *, may_overwrite: bool) -> None:
    """Check that a checkpoint can be put there; missing parents would be made.

    Args:
        key: What was set, as the user knows it.
        path: Where it shall go.
        may_overwrite: Whether a checkpoint that is there may be replaced.

    Raises:
        InvalidValueError: If it cannot be written, or a checkpoint that may not be replaced is
            there.
        CheckpointError: If something that is no checkpoint stands there.
    """
    check_replaceable(path)
    if not may_overwrite and path.is_dir() and any(path.iterdir()):
        allowed = "a new directory, or --overwrite to replace the checkpoint that is there"
        raise InvalidValueError(key, str(path), allowed)
    _check_writable(key, path, next(p for p in path.absolute().parents if p.exists()))


def _check_writable(key: str, path: Path, directory: Path) -> None:
    try:
        tempfile.TemporaryFile(dir=directory).close()
    except OSError as error:
        allowed = f"a place that can be written ({error.strerror or error})"
        raise InvalidValueError(key, str(path), allowed) from None
