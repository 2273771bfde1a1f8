"""Shards: files of consecutive scenes, ``.npz`` without pickle."""

import hashlib
import io
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.datasets.manifest import DatasetError, ShardEntry
from singulate.datasets.scene_record import SceneRecord


class Shard(NamedTuple):
    """The arrays of a shard; see `SceneRecord` for what a row of each is.

    `blocks` is (scenes, N, 4) with the N of the scene that has most; what others lack is NaN.
    """

    seeds: npt.NDArray[np.uint64]
    blocks: npt.NDArray[np.float64]
    masks: npt.NDArray[np.bool_]
    reward_maps: npt.NDArray[np.float16]
    outcomes: npt.NDArray[np.uint8]


def encode_shard(records: Sequence[SceneRecord]) -> bytes:
    """The content of a file, the same bytes for the same scenes."""
    shard = Shard(
        seeds=np.array([record.seed for record in records], np.uint64),
        blocks=_stack_blocks([record.blocks for record in records]),
        masks=np.stack([record.mask for record in records]),
        reward_maps=np.stack([record.reward_map for record in records]),
        outcomes=np.stack([record.outcomes for record in records]),
    )
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **shard._asdict())
    return buffer.getvalue()


def _stack_blocks(blocks: Sequence[npt.NDArray[np.float64]]) -> npt.NDArray[np.float64]:
    stacked = np.full((len(blocks), max(map(len, blocks)), 4), np.nan)
    for row, each in zip(stacked, blocks, strict=True):
        row[: len(each)] = each
    return stacked


def is_intact(path: Path, entry: ShardEntry) -> bool:
    """Whether a file is the one that the manifest describes."""
    try:
        return ShardEntry.of(entry.num_scenes, path.read_bytes()) == entry
    except OSError:
        return False


def read_shard(path: Path, entry: ShardEntry) -> Shard:
    """Read and verify a shard.

    Raises:
        DatasetError: If it is missing or damaged; the text names it.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise DatasetError(f"{path}: {error.strerror or error}") from None
    if hashlib.sha256(data).hexdigest() != entry.sha256:
        raise DatasetError(f"{path}: damaged, its hash is not the manifest's; build it again")
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
            return Shard(**{name: arrays[name] for name in Shard._fields})
    except (ValueError, KeyError, zipfile.BadZipFile) as error:
        raise DatasetError(f"{path}: not a shard ({error})") from None
