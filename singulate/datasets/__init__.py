"""Data sets of reward maps: built on any engine, read with NumPy alone, learned from offline."""

from singulate.datasets.manifest import DatasetConfig, DatasetError, Manifest, read_manifest
from singulate.datasets.recorded_scenes import RecordedScene, RecordedScenes

__all__ = [
    "DatasetConfig",
    "DatasetError",
    "Manifest",
    "RecordedScene",
    "RecordedScenes",
    "read_manifest",
]
