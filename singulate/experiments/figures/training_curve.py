"""How good a training was on its way, on one scale for all rewards."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from singulate.rewards import TERMS, make_reward
from singulate.runs import RunReader
from singulate.runs.record import METRICS_EVERY

NUM_POINTS = 30


def training_curve(run_dir: Path, total_timesteps: int) -> dict[str, list[float]]:
    """Means over equal stretches of a training.

    Trainings on different rewards are compared by what Eq. 7 would have paid for their pushes.

    Args:
        run_dir: The run's directory.
        total_timesteps: Pushes up to which it is read.

    Returns:
        ``steps`` at the end of each stretch, ``reward`` by Eq. 7, and ``success``, the share of
        successful episodes; empty lists where the training was too short.
    """
    reader = RunReader(run_dir)
    success = reader.metrics_since("rollout/success_rate")
    terms = {name: reader.metrics_since(f"reward_terms/{name}").values for name in TERMS}
    reader.close()
    per_stretch = max(1, total_timesteps // (NUM_POINTS * METRICS_EVERY))
    num_points = int((success.steps <= total_timesteps).sum()) // per_stretch
    means = {
        name: values[: num_points * per_stretch].reshape(num_points, per_stretch).mean(axis=1)
        for name, values in {**terms, "rate": success.values}.items()
    }
    paper = make_reward("paper")
    rewards = [paper.total({name: means[name][i] for name in TERMS}) for i in range(num_points)]
    return {
        "steps": [float(METRICS_EVERY * per_stretch * (i + 1)) for i in range(num_points)],
        "reward": [round(float(reward), 2) for reward in rewards],
        "success": [round(float(rate), 4) for rate in means["rate"]],
    }


def stacked(runs: list[Mapping[str, Any]], key: str) -> tuple[Any, Any]:
    """Curves of several seeds over their common steps.

    Args:
        runs: Summaries of equally long trainings.
        key: ``reward`` or ``success``.

    Returns:
        steps float64 (N,), values float64 (num_runs, N).
    """
    length = min(len(run["curve"]["steps"]) for run in runs)
    steps = np.array(runs[0]["curve"]["steps"][:length])
    return steps, np.array([run["curve"][key][:length] for run in runs])
