"""Writing that survives a crash: whole files or none, on disk before they count."""

import os
import secrets
from pathlib import Path


def write_synced(path: Path, data: bytes) -> None:
    """Create a file and wait until its bytes are on disk.

    Raises:
        FileExistsError: If there is one already.
        OSError: If it cannot be written, a full disk included.
    """
    with path.open("xb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def sync_directory(path: Path) -> None:
    """Wait until a directory's entries (new and renamed files) are on disk."""
    descriptor = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def replace_file(path: Path, data: bytes, is_durable: bool = True) -> None:
    """Put a whole file in place at once; a reader sees the old bytes or the new ones.

    Args:
        path: The file; its directory exists.
        data: All of its new content.
        is_durable: Whether to wait for the disk. Without, it is safe against a killed process but
            not against a power cut.

    Raises:
        OSError: If it cannot be written; it names the file, and the old one is untouched.
    """
    partial = path.with_name(f".{path.name}.{secrets.token_hex(4)}.partial")
    try:
        if is_durable:
            write_synced(partial, data)
        else:
            partial.write_bytes(data)
        partial.replace(path)
    except BaseException as error:
        partial.unlink(missing_ok=True)
        if isinstance(error, OSError):
            error.filename = str(path)
        raise
    if is_durable:
        sync_directory(path.parent)
