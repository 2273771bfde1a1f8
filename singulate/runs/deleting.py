"""Removing a run."""

import secrets
import shutil
from pathlib import Path

from singulate.exceptions import RunError
from singulate.runs.lock import RunLock
from singulate.runs.run_directory import RunDirectory


def delete_run(run_dir: Path) -> None:
    """Remove a run directory with everything in it.

    Args:
        run_dir: The run's directory.

    Raises:
        RunError: If there is no run, a trainer is writing it, or it cannot be removed.
    """
    run = RunDirectory(run_dir).open()
    if run_dir.is_symlink():
        raise RunError(f"{run_dir}: is a link; delete what it points to")
    doomed = run_dir.with_name(f".{run_dir.name}.{secrets.token_hex(4)}.deleted")
    with RunLock(run.path):
        try:
            run_dir.rename(doomed)
            shutil.rmtree(doomed)
        except OSError as error:
            raise RunError(f"{run_dir}: cannot be deleted ({error.strerror or error})") from error
