"""Future work of the paper: a state made smaller by an autoencoder, and learning from it."""

from typing import TYPE_CHECKING, Any

import numpy as np

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.checkpoints.reading import read_manifest
from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.style import (
    BLUE,
    NORMAL,
    ORANGE,
    SMALL,
    colour_bar,
    draw_band,
    draw_map,
    empty_figure,
    note_seeds,
    quiet_axes,
    quiet_map,
)
from singulate.experiments.figures.summaries import summarise
from singulate.experiments.figures.training_curve import stacked
from singulate.experiments.shared_autoencoder import ensure_autoencoder

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PANELS = {
    "PPO on fixed-2": ("ppo-fixed-2", "ppo-fixed-2-code"),
    "DQN on random-2": ("dqn-random-2", "dqn-random-2-code"),
}
"""By what is trained: its variants on the distance map and on the code."""
VARIANTS = tuple(variant for pair in PANELS.values() for variant in pair)
SCENARIOS = ("fixed-2", "random-2", "random-3", "random-4", "cluster-4", "cluster-5")
SCENE_SEED = 7


def measure(sources: Sources) -> Data | None:
    """Unseen maps, what is left of them, and curves; None before each variant has a seed."""
    runs = summarise(VARIANTS, sources)
    if not all(runs.values()):
        return None
    return {**_reconstructions(sources.plan.autoencoder, sources), "runs": runs}


def _reconstructions(config: AutoencoderConfig, sources: Sources) -> dict[str, Any]:
    from singulate.agents.autoencoder.quality import reconstruct
    from singulate.agents.autoencoder.scenes import draw_maps
    from singulate.agents.autoencoder.storing import load_autoencoder

    directory = ensure_autoencoder(config, sources.store.autoencoder_dir(config))
    rng = np.random.default_rng(SCENE_SEED)
    maps = np.concatenate([draw_maps(scenario, 1, rng) for scenario in SCENARIOS])
    made = reconstruct(load_autoencoder(directory), maps)
    return {
        "quality": read_manifest(directory).notes["quality"],
        "scenes": [
            {
                "scenario": scenario,
                "map_px": before.astype(float).round(2).tolist(),
                "reconstruction_px": after.astype(float).round(2).tolist(),
            }
            for scenario, before, after in zip(SCENARIOS, maps, made, strict=True)
        ],
    }


def draw(data: Data) -> "Figure":
    """Maps above, reconstructions below them, and the learning curves at the bottom."""
    figure = empty_figure(4.9)
    grid = figure.add_gridspec(2, 1, height_ratios=(1.0, 1.0))
    upper, lower = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    _draw_maps(upper, data["scenes"])
    panels = lower.subplots(1, len(PANELS), sharey=True)
    for panel, (title, (on_map, on_code)) in zip(panels, PANELS.items(), strict=True):
        quiet_axes(panel, title)
        draw_band(panel, *stacked(data["runs"][on_map], "success"), BLUE, "distance map")
        draw_band(panel, *stacked(data["runs"][on_code], "success"), ORANGE, "learned code")
        panel.set_xlabel("pushes (thousands)", fontsize=SMALL)
        panel.set_ylim(0.0, 1.0)
    panels[0].set_ylabel("success", fontsize=NORMAL)
    panels[0].legend(frameon=False, fontsize=SMALL, loc="upper left")
    num_seeds = min(len(data["runs"][variant]) for variant in VARIANTS)
    error = data["quality"]["mean_absolute_error_px"]
    note_seeds(lower, "Learning curves", num_seeds, f"; mean error of maps {error:.2f} px")
    return figure


def _draw_maps(figure: Any, scenes: list[Any]) -> None:
    """One scene a column; white is inside."""
    panels = figure.subplots(2, len(scenes))
    highest = max(np.max(scene["map_px"]) for scene in scenes)
    rows = {"map_px": "distance map", "reconstruction_px": "out of its code"}
    for row, (key, label) in enumerate(rows.items()):
        for panel, scene in zip(panels[row], scenes, strict=True):
            outside = np.ma.masked_less(np.array(scene[key]), 0.0)
            panel.set_facecolor("white")
            image = draw_map(panel, outside, (0.0, highest))
            quiet_map(panel, scene["scenario"] if row == 0 else "")
        panels[row][0].set_ylabel(label, fontsize=SMALL)
    colour_bar(figure, image, panels.ravel(), "px (white: inside)")


FIGURE = PaperFigure("autoencoder", "A smaller state, learnt without rewards", VARIANTS,
                     measure, draw)  # fmt: skip
