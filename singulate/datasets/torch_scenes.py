"""A data set for PyTorch's loader."""

from pathlib import Path
from typing import Any

import torch
from torch.utils.data import Dataset

from singulate.datasets.recorded_scenes import RecordedScenes
from singulate.perception.distance_map import distance_map


class TorchScenes(Dataset[dict[str, torch.Tensor]]):
    """What an agent sees of each scene, and what every push on it is worth.

    Items are dictionaries: ``distance_map`` float32 (64, 64), ``mask`` bool (64, 64),
    ``reward_map`` float32 (4, R, R), ``outcomes`` uint8 (4, R, R). Workers of a loader open the
    files themselves. A loader that shuffles scenes of more than 64 shards reads files again and
    again.

    Args:
        directory: Where the data set lies.

    Raises:
        DatasetError: If it is missing, damaged or incomplete.
    """

    def __init__(self, directory: str | Path) -> None:
        self._directory = directory
        self._scenes = RecordedScenes(directory)

    def __len__(self) -> int:
        return len(self._scenes)

    def __getitem__(self, index: int) -> dict[str, torch.Tensor]:
        """A scene by its number."""
        scene = self._scenes[index]
        return {
            "distance_map": torch.from_numpy(distance_map(scene.mask)),
            "mask": torch.from_numpy(scene.mask.copy()),
            "reward_map": torch.from_numpy(scene.reward_map),
            "outcomes": torch.from_numpy(scene.outcomes.copy()),
        }

    def __getstate__(self) -> dict[str, Any]:
        return {"directory": self._directory}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._directory = state["directory"]
        self._scenes = RecordedScenes(self._directory)
