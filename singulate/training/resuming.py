"""Continuing a run from its newest checkpoint, or refusing to before anything is lost."""

from stable_baselines3.common.base_class import BaseAlgorithm

from singulate.checkpoints import list_checkpoints, read_checkpoint
from singulate.exceptions import CheckpointError, ResumeError
from singulate.runs import RunDirectory, RunReader
from singulate.training.envs import TrainingEnvs
from singulate.training.training_state import restore_training


def resume_training(model: BaseAlgorithm, envs: TrainingEnvs, run: RunDirectory) -> int:
    """Load the newest checkpoint that verifies; nothing of the run is changed.

    Returns:
        The step that it was saved at, 0 where the run has neither pushes nor checkpoints.

    Raises:
        ResumeError: If there is something to continue but no intact checkpoint of it, or the
            checkpoint does not fit.
        RunError: If the record is damaged.
    """
    newest = run.latest_checkpoint()
    if newest is not None:
        try:
            restore_training(model, envs, read_checkpoint(newest).files)
        except CheckpointError as error:
            raise ResumeError(str(error)) from error
    else:
        _refuse_to_start_over(run)
    return model.num_timesteps


def _refuse_to_start_over(run: RunDirectory) -> None:
    reader = RunReader(run.path)
    try:
        num_pushes = reader.count_pushes()
    finally:
        reader.close()
    num_checkpoints = len(list_checkpoints(run.checkpoints_path))
    if num_pushes or num_checkpoints:
        raise ResumeError(
            f"{run.checkpoints_path}: none of {num_checkpoints} checkpoints is intact, the "
            f"{num_pushes} recorded pushes cannot be continued; put a copy of a checkpoint back, "
            "or train in a new directory"
        )
