"""The environments that a training pushes in, here or in worker processes."""

from singulate.training.config import TrainingConfig
from singulate.training.local_envs import LocalEnvs
from singulate.training.workers.worker_envs import WorkerEnvs

TrainingEnvs = LocalEnvs | WorkerEnvs
"""Both give the same results; they differ in speed and in what a crash ends."""


def make_training_envs(config: TrainingConfig) -> TrainingEnvs:
    """The environments of a run at the beginning of their first episodes."""
    num_workers = config.resolved_num_workers
    return WorkerEnvs(config, num_workers) if num_workers else LocalEnvs(config)
