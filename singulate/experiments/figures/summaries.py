"""What the figures and claims need of each finished training, small enough to be committed."""

from collections.abc import Iterable, Mapping
from typing import Any

from singulate.evaluation import wilson_interval
from singulate.experiments.cell import Cell
from singulate.experiments.cell_store import CellStore
from singulate.experiments.figures.paper_figure import Sources
from singulate.experiments.figures.training_curve import training_curve
from singulate.experiments.figures.variants import VARIANTS

Summary = Mapping[str, Any]
"""Plain values of one training: see `summarise_variant`."""
Summaries = dict[str, list[Summary]]
"""By variant, one a finished seed."""


def summarise(names: Iterable[str], sources: Sources) -> Summaries:
    """Summaries of all finished trainings of some variants."""
    return {name: summarise_variant(name, sources) for name in names}


def summarise_variant(name: str, sources: Sources) -> list[Summary]:
    """One entry for each finished seed whose run can be read from here, or that is published.

    Returns:
        Each with ``key`` (`Cell.key`), ``seed``, ``num_steps``, ``success_rate`` on unseen scenes
        with its ``success_interval_95``, ``num_episodes``, ``mean_reward`` and ``curve``
        (`training_curve`).
    """
    summaries = []
    for cell in VARIANTS[name].cells(sources.plan):
        summary = _summary(cell, sources.store) or sources.published.summaries.get(cell.key)
        if summary is not None:
            summaries.append(summary)
    return summaries


def _summary(cell: Cell, store: CellStore) -> Summary | None:
    result = store.read(cell)
    if result is None or not store.has_run(cell):
        return None
    return {
        "key": cell.key,
        "seed": cell.training.seed,
        "num_steps": cell.training.total_timesteps,
        "success_rate": result.num_successes / result.num_episodes,
        "success_interval_95": list(wilson_interval(result.num_successes, result.num_episodes)),
        "num_episodes": result.num_episodes,
        "mean_reward": round(result.mean_reward, 2),
        "curve": training_curve(store.run_dir(cell), cell.training.total_timesteps),
    }
