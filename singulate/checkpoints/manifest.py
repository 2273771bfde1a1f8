"""What a checkpoint says about itself."""

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from typing import Any, NoReturn, Self

from singulate.checkpoints.tensors import one_line
from singulate.exceptions import CheckpointError

FORMAT = "singulate-checkpoint"
FORMAT_VERSION = 1
MANIFEST_NAME = "manifest.json"
MAX_MANIFEST_BYTES = 1 << 20
FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}")
"""Names of files in a checkpoint: plain, never a path."""


@dataclass(frozen=True)
class FileEntry:
    """Size [bytes] and SHA-256 of one file of a checkpoint."""

    size: int
    sha256: str

    @classmethod
    def of(cls, data: bytes) -> Self:
        """Entry for a file with this content."""
        return cls(len(data), hashlib.sha256(data).hexdigest())


@dataclass(frozen=True)
class Manifest:
    """A checkpoint's description.

    Attributes:
        agent: Kind of agent, such as ``dqn``, or ``autoencoder``.
        agent_config: All that is needed to rebuild its model.
        env_config: The environment it was trained in.
        step: Training steps behind it.
        notes: Anything else worth keeping (seed, command, measured success).
        created: Time of saving, ISO 8601, UTC.
        files: Size and hash by file name; filled in when the checkpoint is saved.
    """

    agent: str
    agent_config: Mapping[str, Any]
    env_config: Mapping[str, Any]
    step: int
    notes: Mapping[str, Any] = field(default_factory=dict)
    created: str = field(default_factory=lambda: datetime.now(UTC).isoformat(timespec="seconds"))
    files: Mapping[str, FileEntry] = field(default_factory=dict)

    def to_bytes(self) -> bytes:
        """JSON text with a checksum over all of it.

        Raises:
            CheckpointError: If a configuration cannot be written as JSON, NaN included.
        """
        content = {"format": FORMAT, "format_version": FORMAT_VERSION, **asdict(self)}
        try:
            content["checksum"] = _checksum(content)
            return (json.dumps(content, indent=2, allow_nan=False) + "\n").encode()
        except (TypeError, ValueError) as error:
            raise CheckpointError(f"manifest cannot be written: {one_line(error)}") from error

    @classmethod
    def from_bytes(cls, data: bytes, source: str) -> Self:
        """The inverse of `to_bytes`.

        Args:
            data: Content of a manifest file from anywhere.
            source: What to call it in an error.

        Raises:
            CheckpointError: If it is damaged, was changed by hand, or is not one of ours.
        """
        content = _parse(data, source)
        checksum = content.pop("checksum", None)
        try:
            is_intact = checksum == _checksum(content)
        except ValueError:  # a number that overflows, such as 1e999
            is_intact = False
        if not is_intact:
            raise CheckpointError(f"{source}: damaged or changed since it was written")
        del content["format"], content["format_version"]
        _check_types(content, source)
        entries = {
            name: _entry(f"{source}: {name}", value) for name, value in content["files"].items()
        }
        for name in entries:
            if FILE_NAME.fullmatch(name) is None or name == MANIFEST_NAME:
                raise CheckpointError(f"{source}: file name {name!r} is not allowed")
        return cls(**{**content, "files": entries})


TYPES: Mapping[str, type] = {
    "agent": str,
    "agent_config": dict,
    "env_config": dict,
    "step": int,
    "notes": dict,
    "created": str,
    "files": dict,
}


def _checksum(content: Mapping[str, Any]) -> str:
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def _parse(data: bytes, source: str) -> dict[str, Any]:
    try:
        content = json.loads(data, parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise CheckpointError(f"{source}: not valid JSON: {one_line(error)}") from error
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise CheckpointError(f"{source}: not the manifest of a singulate checkpoint")
    version = content.get("format_version")
    if version != FORMAT_VERSION:
        raise CheckpointError(
            f"{source}: format version {version!r} is unknown; known: {FORMAT_VERSION}"
        )
    return content


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is not a number")


def _check_types(content: Mapping[str, Any], source: str) -> None:
    if set(content) != set(TYPES):
        different = ", ".join(sorted(set(content) ^ set(TYPES)))
        raise CheckpointError(f"{source}: missing or unknown keys: {different}")
    for key, kind in TYPES.items():
        value = content[key]
        if not isinstance(value, kind) or isinstance(value, bool):
            raise CheckpointError(f"{source}: {key} has to be of type {kind.__name__}")
    if content["step"] < 0:
        raise CheckpointError(f"{source}: step has to be 0 or more")


def _entry(source: str, value: object) -> FileEntry:
    if isinstance(value, dict) and set(value) == {"size", "sha256"}:
        size, digest = value["size"], value["sha256"]
        if type(size) is int and size >= 0 and isinstance(digest, str):
            return FileEntry(size, digest)
    raise CheckpointError(f"{source}: has to have a size and a sha256")
