"""The environment that a run learns in: the simulation, or a data set."""

from pathlib import Path

from singulate.datasets import RecordedScenes
from singulate.datasets.recorded_env import RecordedPushEnv
from singulate.envs import PushEnv
from singulate.exceptions import InvalidValueError
from singulate.training.config import TrainingConfig

TrainingEnv = PushEnv | RecordedPushEnv


def make_training_env(config: TrainingConfig) -> TrainingEnv:
    """Build it.

    Raises:
        DatasetError: If the run's data set is missing or damaged.
        InvalidValueError: If it is another one than the run began with, or made for another task.
    """
    if config.dataset is None:
        return PushEnv(None, **config.env.to_dict())
    scenes = RecordedScenes(Path(config.dataset))
    if config.dataset_sha256 not in (None, scenes.manifest.sha256):
        allowed = f"the data set that the run began with, SHA-256 {config.dataset_sha256}"
        raise InvalidValueError("dataset", config.dataset, allowed)
    return RecordedPushEnv(scenes, config.env)
