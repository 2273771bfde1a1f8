"""Writing a checkpoint: all of it or nothing."""

import fcntl
import os
import re
import secrets
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import numpy.typing as npt

from singulate.checkpoints.durable import sync_directory, write_synced
from singulate.checkpoints.manifest import FILE_NAME, FORMAT, MANIFEST_NAME, FileEntry, Manifest
from singulate.checkpoints.tensors import encode_tensors
from singulate.exceptions import CheckpointError

WEIGHTS_NAME = "weights.safetensors"
README_NAME = "README.md"
"""Written for people, so it is the one file that may be edited later: the manifest omits it."""

LEFTOVER = re.compile(r"\.(?P<name>.+)\.[0-9a-f]{8}\.(?P<kind>partial|replaced)")


def save_checkpoint(
    directory: Path,
    tensors: Mapping[str, npt.NDArray[np.generic]],
    manifest: Manifest,
    extra_files: Mapping[str, bytes] | None = None,
) -> Path:
    """Save a checkpoint atomically; whatever happens, no half-written one is ever in place.

    Everything is written into a hidden directory beside the final one, each file forced to disk,
    the manifest last; then the directory is renamed. A checkpoint of the same name is replaced.

    Args:
        directory: Where it goes; parents are made.
        tensors: Weights by name, finite.
        manifest: Its description; `files` is filled in here.
        extra_files: More files by plain name. ``README.md`` may be edited later, all others are
            verified when read.

    Returns:
        `directory`.

    Raises:
        CheckpointError: If a value is not finite, a file name is not allowed, something that is
            no checkpoint stands there, or the disk is full or not writable. Earlier checkpoints
            are untouched and nothing is left behind.
    """
    contents = {WEIGHTS_NAME: encode_tensors(tensors), **(extra_files or {})}
    for name in contents:
        if FILE_NAME.fullmatch(name) is None or name == MANIFEST_NAME:
            raise CheckpointError(f"{directory}: file name {name!r} is not allowed")
    if extra_files and WEIGHTS_NAME in extra_files:
        raise CheckpointError(f"{directory}: {WEIGHTS_NAME} is made from the tensors")
    entries = {name: FileEntry.of(data) for name, data in contents.items() if name != README_NAME}
    contents[MANIFEST_NAME] = replace(manifest, files=entries).to_bytes()
    try:
        directory.parent.mkdir(parents=True, exist_ok=True)
        tidy(directory.parent)
        with _partial_directory(directory) as partial:
            for name, data in contents.items():
                write_synced(partial / name, data)
            sync_directory(partial)
            _put_in_place(partial, directory)
        sync_directory(directory.parent)
    except OSError as error:
        raise CheckpointError(
            f"{directory}: could not be saved ({error.strerror or error}); "
            "earlier checkpoints are untouched"
        ) from error
    return directory


def check_replaceable(directory: Path) -> None:
    """Check that saving a checkpoint there destroys nothing but a checkpoint.

    Its manifest may be damaged, as long as it says whose it is.

    Raises:
        CheckpointError: If something else stands there.
        OSError: If it cannot be looked at.
    """
    if not os.path.lexists(directory):
        return
    if directory.is_dir() and not any(directory.iterdir()):
        return
    manifest = directory / MANIFEST_NAME
    if manifest.is_file():
        with manifest.open("rb") as file:
            if f'"format": "{FORMAT}"'.encode() in file.read(1024):
                return
    raise CheckpointError(f"{directory}: is there already and is not a checkpoint")


def tidy(parent: Path) -> None:
    """Remove what a killed writer left behind; one that was being replaced is put back.

    Args:
        parent: Directory of checkpoints. Directories that a living process is writing are left.
    """
    for path in parent.iterdir():
        match = LEFTOVER.fullmatch(path.name)
        if match is None or not path.is_dir() or _is_being_written(path):
            continue
        target = parent / match["name"]
        if match["kind"] == "replaced" and not target.exists():
            path.rename(target)
        else:
            shutil.rmtree(path, ignore_errors=True)


@contextmanager
def _partial_directory(directory: Path) -> Iterator[Path]:
    partial = directory.with_name(f".{directory.name}.{secrets.token_hex(4)}.partial")
    partial.mkdir()
    descriptor = os.open(partial, os.O_RDONLY | os.O_DIRECTORY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield partial
    finally:
        os.close(descriptor)
        shutil.rmtree(partial, ignore_errors=True)


def _is_being_written(partial: Path) -> bool:
    try:
        descriptor = os.open(partial, os.O_RDONLY | os.O_DIRECTORY)
    except FileNotFoundError:
        return True
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    finally:
        os.close(descriptor)
    return False


def _put_in_place(partial: Path, directory: Path) -> None:
    check_replaceable(directory)
    if not directory.exists() or not any(directory.iterdir()):
        partial.rename(directory)
        return
    replaced = directory.with_name(f".{directory.name}.{secrets.token_hex(4)}.replaced")
    directory.rename(replaced)
    try:
        partial.rename(directory)
    except BaseException:
        replaced.rename(directory)
        raise
    shutil.rmtree(replaced, ignore_errors=True)
