"""Where runs and the shipped checkpoints live."""

import os
from pathlib import Path

RUNS_VARIABLE = "SINGULATE_RUNS"
"""Environment variable that moves the directory of all runs."""


def default_runs_directory() -> Path:
    """Directory that new runs are put in: ``$SINGULATE_RUNS``, else ``runs`` in the current one."""
    return Path(os.environ.get(RUNS_VARIABLE) or "runs")


def shipped_checkpoints_directory() -> Path:
    """Directory of the checkpoints that come with the repository, beside the package."""
    return Path(__file__).resolve().parent.parent / "checkpoints"


def figures_directory() -> Path:
    """Directory of the reproduced figures that come with the repository, beside the package."""
    return Path(__file__).resolve().parent.parent / "static" / "figures"
