"""Reads a data set scene by scene, with NumPy alone."""

from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.datasets.manifest import DatasetError, read_manifest, shard_name
from singulate.datasets.shard import Shard, read_shard
from singulate.geometry import Block

NUM_CACHED_SHARDS = 64
"""Some 400 MiB of 64 x 64 maps."""


class RecordedScene(NamedTuple):
    """A scene of a data set; see `SceneRecord` for the arrays."""

    seed: int
    layout: tuple[Block, ...]
    mask: npt.NDArray[np.bool_]
    reward_map: npt.NDArray[np.float32]
    outcomes: npt.NDArray[np.uint8]


class RecordedScenes:
    """A complete data set, read and verified shard by shard as scenes are asked for.

    Args:
        directory: Where it lies.

    Raises:
        DatasetError: If it is missing, damaged or incomplete.
    """

    def __init__(self, directory: str | Path) -> None:
        self._directory = directory = Path(directory)
        self.manifest = read_manifest(directory)
        if not self.manifest.is_complete:
            raise DatasetError(f"{directory}: incomplete; run the command that builds it again")
        self._shard = lru_cache(maxsize=NUM_CACHED_SHARDS)(self._read)

    def __len__(self) -> int:
        return self.manifest.config.num_scenes

    def __getitem__(self, index: int) -> RecordedScene:
        """A scene by its number.

        Raises:
            IndexError: If there is no such scene.
            DatasetError: If its shard is damaged; the text names it.
        """
        if not 0 <= index < len(self):
            raise IndexError(index)
        number, row = divmod(index, self.manifest.config.shard_size)
        shard = self._shard(number)
        return RecordedScene(
            seed=int(shard.seeds[row]),
            layout=tuple(
                Block(*map(float, block))
                for block in shard.blocks[row]
                if not np.isnan(block).all()
            ),
            mask=shard.masks[row],
            reward_map=shard.reward_maps[row].astype(np.float32),
            outcomes=shard.outcomes[row],
        )

    def _read(self, number: int) -> Shard:
        return read_shard(self._directory / shard_name(number), self.manifest.shards[number])
