"""Reading a checkpoint that may be damaged or come from a stranger."""

import hashlib
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from singulate.checkpoints.manifest import (
    MANIFEST_NAME,
    MAX_MANIFEST_BYTES,
    FileEntry,
    Manifest,
)
from singulate.checkpoints.saving import WEIGHTS_NAME
from singulate.checkpoints.tensors import Tensors, decode_tensors
from singulate.exceptions import CheckpointError

MAX_WEIGHTS_BYTES = 1 << 29
MAX_FILE_BYTES = 1 << 32
CHUNK_BYTES = 1 << 20


@dataclass(frozen=True)
class Checkpoint:
    """A checkpoint that was read and verified.

    Attributes:
        manifest: Its description.
        tensors: Weights by name, writable arrays with finite values.
        files: Content of the other verified files by name.
    """

    manifest: Manifest
    tensors: Tensors
    files: dict[str, bytes]


def read_checkpoint(directory: Path, with_files: bool = True) -> Checkpoint:
    """Read and verify a checkpoint; nothing in it is ever executed.

    Args:
        directory: A directory that `save_checkpoint` wrote, or claims to be one.
        with_files: Whether to read the other files too, not only the weights.

    Raises:
        CheckpointError: If it is missing, truncated, tampered with, too big, foreign, or holds
            values that are not finite.
    """
    manifest = read_manifest(directory)
    weights = _read(directory / WEIGHTS_NAME, manifest.files[WEIGHTS_NAME], MAX_WEIGHTS_BYTES)
    tensors = decode_tensors(weights, str(directory / WEIGHTS_NAME))
    names = [name for name in manifest.files if with_files and name != WEIGHTS_NAME]
    files = {name: _read(directory / name, manifest.files[name], MAX_FILE_BYTES) for name in names}
    return Checkpoint(manifest, tensors, files)


def verify_checkpoint(directory: Path) -> Manifest:
    """Check size and hash of every file without keeping them in memory.

    Returns:
        The manifest.

    Raises:
        CheckpointError: If anything is missing or differs from the manifest.
    """
    manifest = read_manifest(directory)
    for name, entry in manifest.files.items():
        with _open(directory / name, entry.size, MAX_FILE_BYTES) as file:
            digest = hashlib.sha256()
            while chunk := file.read(CHUNK_BYTES):
                digest.update(chunk)
        _check_hash(directory / name, digest.hexdigest(), entry)
    return manifest


def read_manifest(directory: Path) -> Manifest:
    """Read a checkpoint's description alone.

    Raises:
        CheckpointError: If the directory is no checkpoint or the manifest is damaged.
    """
    path = directory / MANIFEST_NAME
    if not directory.exists():
        raise CheckpointError(f"{directory}: there is no such checkpoint directory")
    if not directory.is_dir():
        raise CheckpointError(f"{directory}: not a singulate checkpoint, which is a directory")
    if not path.exists():
        raise CheckpointError(f"{directory}: not a singulate checkpoint, it has no {MANIFEST_NAME}")
    with _open(path, None, MAX_MANIFEST_BYTES) as file:
        manifest = Manifest.from_bytes(file.read(MAX_MANIFEST_BYTES), str(path))
    if WEIGHTS_NAME not in manifest.files:
        raise CheckpointError(f"{path}: lists no {WEIGHTS_NAME}")
    return manifest


def _read(path: Path, entry: FileEntry, max_bytes: int) -> bytes:
    with _open(path, entry.size, max_bytes) as file:
        data = file.read(entry.size + 1)
    _check_hash(path, hashlib.sha256(data).hexdigest(), entry)
    return data


@contextmanager
def _open(path: Path, size: int | None, max_bytes: int) -> Iterator[BinaryIO]:
    try:
        # A pipe in the place of a file must not block the reader.
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb") as file:
            found = os.fstat(file.fileno())
            if not stat.S_ISREG(found.st_mode):
                raise CheckpointError(f"{path}: not a regular file")
            if found.st_size > max_bytes:
                raise CheckpointError(
                    f"{path}: {found.st_size} bytes are more than the {max_bytes} allowed"
                )
            if size is not None and found.st_size != size:
                raise CheckpointError(f"{path}: has {found.st_size} bytes instead of {size}")
            yield file
    except OSError as error:
        raise CheckpointError(f"{path}: cannot be read ({error.strerror or error})") from error


def _check_hash(path: Path, digest: str, entry: FileEntry) -> None:
    if digest != entry.sha256:
        raise CheckpointError(f"{path}: damaged or changed, its SHA-256 is not the manifest's")
