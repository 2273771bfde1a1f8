"""Fig. 2: what every push is paid by Eq. 7, by its start and direction."""

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
from singulate.geometry import Direction, Workspace, standing_pose
from singulate.rewardmap import RewardMapRequest, compute_reward_map
from singulate.simulation import make_scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SCENES = {"fixed-3": 0, "random-2": 3}
"""Seeds by scenario: the scene of Fig. 1, and one of two blocks at a random place."""


def measure(sources: Sources) -> Data:
    """Rewards (4, R, R) of each scene: up, right, down, left."""
    scenes: list[dict[str, Any]] = []
    for scenario, seed in SCENES.items():
        layout = make_scenario(scenario).sample(np.random.default_rng(seed), Workspace())
        poses = tuple(standing_pose(block) for block in layout)
        request = RewardMapRequest(poses, sources.plan.resolution)
        values = compute_reward_map(request, sources.engine).values
        rewards = values.astype(float).round(1).tolist()
        scenes.append(
            {"scenario": scenario, "seed": seed, "rewards": rewards, "blocks": outlines(poses)}
        )
    return {"reward": "paper", "directions": [d.label for d in Direction], "scenes": scenes}


def draw(data: Data) -> "Figure":
    """One scene a row, one direction a column, one scale for all."""
    figure, panels = new_figure(len(data["scenes"]), 4, 3.35)
    limits = [np.array(scene["rewards"]) for scene in data["scenes"]]
    low, high = min(r.min() for r in limits), max(r.max() for r in limits)
    for row, scene in enumerate(data["scenes"]):
        of_row = panels[4 * row : 4 * row + 4]
        for panel, label, rewards in zip(of_row, data["directions"], scene["rewards"], strict=True):
            image = draw_map(panel, rewards, (low, high))
            draw_blocks(panel, scene["blocks"])
            quiet_map(panel, f"push {label}" if row == 0 else "")
        of_row[0].set_ylabel(scene["scenario"], fontsize=NORMAL)
    colour_bar(figure, image, panels, "reward of a push that starts there (Eq. 7)")
    return figure


FIGURE = PaperFigure("fig2", "Reward of every push on two scenes", (), measure, draw)
