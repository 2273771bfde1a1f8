"""Fig. 1: what the camera sees of three blocks, as picture, mask and distance map."""

from typing import TYPE_CHECKING

import numpy as np

from singulate.envs.push_task import PushTask
from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.style import colour_bar, draw_map, new_figure, quiet_map
from singulate.geometry import Workspace
from singulate.simulation import make_scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SCENARIO = "fixed-3"


def measure(sources: Sources) -> Data:
    """The three pictures, (64, 64) each."""
    task = PushTask()
    task.place(make_scenario(SCENARIO).sample(np.random.default_rng(0), Workspace()))
    rgb, percept = task.scene.photograph().rgb, task.percept
    task.close()
    return {
        "scenario": SCENARIO,
        "rgb": rgb.tolist(),
        "mask": percept.mask.astype(int).tolist(),
        "distance_map_px": percept.distance_map.astype(float).round(2).tolist(),
    }


def draw(data: Data) -> "Figure":
    """Side by side, as in the paper."""
    figure, panels = new_figure(1, 3, 2.4)
    distances = np.array(data["distance_map_px"])
    draw_map(panels[0], np.array(data["rgb"], np.uint8), (0, 255))
    draw_map(panels[1], data["mask"], (0, 1), cmap="gray")
    outside = np.ma.masked_less(distances, 0.0)
    panels[2].set_facecolor("white")
    image = draw_map(panels[2], outside, (0.0, distances.max()))
    for panel, title in zip(panels, ("camera", "binary mask", "distance map"), strict=True):
        quiet_map(panel, title)
    colour_bar(figure, image, panels[2:], "px (white: inside, \N{MINUS SIGN}1)")
    return figure


FIGURE = PaperFigure("fig1", "Three blocks as the agent may see them", (), measure, draw)
