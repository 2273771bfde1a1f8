"""Fig. 6: where PPO starts its pushes while it learns to start beside the blocks."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.style import (
    NORMAL,
    colour_bar,
    draw_blocks,
    draw_map,
    new_figure,
    outlines,
    quiet_map,
)
from singulate.experiments.figures.variants import VARIANTS
from singulate.geometry import Workspace, standing_pose
from singulate.rewards import TERMS, make_reward
from singulate.runs import RunReader
from singulate.simulation import make_scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure

VARIANT = "ppo-fixed-2-start"
NUM_MOMENTS = 3
"""20,000, 40,000 and 60,000 pushes of a full training."""
WINDOW = 2048
"""Pushes before each moment that are counted: one update of PPO (Table 1)."""
NUM_CELLS = 32


def measure(sources: Sources) -> Data | None:
    """Starts by cell and their spread, for every finished seed and moment; None without any."""
    variant = VARIANTS[VARIANT]
    layout = make_scenario(variant.env.scenario).sample(np.random.default_rng(0), Workspace())
    seeds = []
    for cell in variant.cells(sources.plan):
        if sources.store.has_run(cell):
            total, run_dir = cell.training.total_timesteps, sources.store.run_dir(cell)
            moments = [total * (i + 1) // NUM_MOMENTS for i in range(NUM_MOMENTS)]
            seeds.append({"seed": cell.training.seed,
                          "moments": [_moment(run_dir, step) for step in moments]})  # fmt: skip
    if not seeds:
        return None
    blocks = outlines(tuple(standing_pose(block) for block in layout))
    return {"scenario": variant.env.scenario, "reward": variant.env.reward, "window": WINDOW,
            "seeds": seeds, "blocks": blocks}  # fmt: skip


def _moment(run_dir: Path, step: int) -> dict[str, Any]:
    reader = RunReader(run_dir)
    starts = reader.starts(step - WINDOW + 1, step)
    terms = {}
    for name in TERMS:
        series = reader.metrics_since(f"reward_terms/{name}", step - WINDOW)
        terms[name] = float(np.mean(series.values[series.steps <= step]))
    reader.close()
    half = Workspace().half_length
    edges = np.linspace(-half, half, NUM_CELLS + 1)
    counts, _, _ = np.histogram2d(-starts[:, 1], starts[:, 0], bins=(edges, edges))  # row 0: +y
    return {
        "step": step,
        "mean_m": starts.mean(axis=0).astype(float).round(4).tolist(),
        "deviation_m": starts.std(axis=0).astype(float).round(4).tolist(),
        "share_inside": round(terms["inside"], 4),
        "mean_reward": round(make_reward("start").total(terms), 2),
        "counts": counts.astype(int).tolist(),
    }


def draw(data: Data) -> "Figure":
    """One seed a row, one moment a column; brightness by the share of starts in a cell."""
    seeds = data["seeds"][:3]
    figure, panels = new_figure(len(seeds), NUM_MOMENTS, 0.4 + 2.1 * len(seeds))
    for row, seed in enumerate(seeds):
        for column, moment in enumerate(seed["moments"]):
            panel = panels[NUM_MOMENTS * row + column]
            counts = np.array(moment["counts"], float)
            image = draw_map(panel, np.sqrt(counts / counts.max()), (0.0, 1.0), cmap="Blues")
            draw_blocks(panel, data["blocks"], colour="0.2")
            quiet_map(panel, f"{moment['step']:,} pushes" if row == 0 else "")
        panels[NUM_MOMENTS * row].set_ylabel(f"seed {seed['seed']}", fontsize=NORMAL)
    colour_bar(figure, image, panels, "starts in a cell, root scale")
    return figure


FIGURE = PaperFigure("fig6", "Where PPO starts its pushes", (VARIANT,), measure, draw)
