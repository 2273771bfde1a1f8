"""What the figures and claims need of each finished training, small enough to be committed."""

from collections.abc import Iterable
from typing import Any

from singulate.evaluation import wilson_interval
from singulate.experiments.cell_store import CellStore
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.training_curve import training_curve
from singulate.experiments.figures.variants import VARIANTS

Summary = dict[str, Any]
"""Plain values of one training: see `summarise_variant`."""
Summaries = dict[str, list[Summary]]
"""By variant, one a finished seed."""


def summarise(names: Iterable[str], plan: Plan, store: CellStore) -> Summaries:
    """Summaries of all finished trainings of some variants."""
    return {name: summarise_variant(name, plan, store) for name in names}


def summarise_variant(name: str, plan: Plan, store: CellStore) -> list[Summary]:
    """One entry for each finished seed.

    Returns:
        Each with ``seed``, ``num_steps``, ``success_rate`` on unseen scenes with its
        ``success_interval_95``, ``num_episodes``, ``mean_reward`` and ``curve`` (`training_curve`).
    """
    summaries = []
    for cell in VARIANTS[name].cells(plan):
        result = store.read(cell)
        if result is None:
            continue
        summaries.append(
            {
                "seed": cell.training.seed,
                "num_steps": cell.training.total_timesteps,
                "success_rate": result.num_successes / result.num_episodes,
                "success_interval_95": list(
                    wilson_interval(result.num_successes, result.num_episodes)
                ),
                "num_episodes": result.num_episodes,
                "mean_reward": round(result.mean_reward, 2),
                "curve": training_curve(store.run_dir(cell), cell.training.total_timesteps),
            }
        )
    return summaries
