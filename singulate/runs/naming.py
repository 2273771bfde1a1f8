"""How new runs are named."""

from datetime import datetime
from pathlib import Path


def new_run_directory(runs_dir: Path, agent: str, scenario: str) -> Path:
    """A directory that is not there yet: time, agent and scenario, so that names sort by age.

    Args:
        runs_dir: Directory of all runs; it need not exist.
        agent: Kind of agent.
        scenario: Name of the scenario.

    Returns:
        Its path, such as ``runs/20240131-235959-dqn-random-2``; a further ``-2`` and so on keeps
        runs of the same second apart. It is not made.
    """
    name = f"{datetime.now():%Y%m%d-%H%M%S}-{agent}-{scenario}"
    path, number = runs_dir / name, 1
    while path.exists():
        number += 1
        path = runs_dir / f"{name}-{number}"
    return path
