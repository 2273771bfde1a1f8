"""Fig. 3: what state, action and reward of the proposed task bring against simpler ones."""

from typing import TYPE_CHECKING

from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.style import (
    BLUE,
    NORMAL,
    ORANGE,
    SMALL,
    draw_band,
    new_figure,
    note_seeds,
    quiet_axes,
)
from singulate.experiments.figures.summaries import summarise
from singulate.experiments.figures.training_curve import stacked

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PROPOSED = "ppo-fixed-2"
COMPARISONS = {
    "state": ("ppo-fixed-2-mask", "distance map", "binary mask"),
    "action": ("ppo-fixed-2-start-end", "point and direction", "start and end"),
    "reward": ("ppo-fixed-2-separation", "Eq. 7", "$r_{Dist}$ alone"),
}
"""By what is compared: the baseline's variant, and names of proposed and baseline."""
VARIANTS = (PROPOSED, *(variant for variant, _, _ in COMPARISONS.values()))
LEGEND_ROOM = 1.35
"""Height of the upper row against its curves."""
ROWS = {"reward": "reward by Eq. 7", "success": "success"}


def measure(sources: Sources) -> Data | None:
    """Curves of every seed; None before each variant has one."""
    runs = summarise(VARIANTS, sources)
    return {"scenario": "fixed-2", "runs": runs} if all(runs.values()) else None


def draw(data: Data) -> "Figure":
    """One comparison a column; reward above, success below."""
    figure, panels = new_figure(2, 3, 4.2, sharex="col", sharey="row")
    runs = data["runs"]
    for row, (key, label) in enumerate(ROWS.items()):
        for column, (title, (variant, ours, theirs)) in enumerate(COMPARISONS.items()):
            panel = panels[3 * row + column]
            quiet_axes(panel, title if row == 0 else "")
            draw_band(panel, *stacked(runs[PROPOSED], key), BLUE, ours)
            draw_band(panel, *stacked(runs[variant], key), ORANGE, theirs)
            if row == 0:
                panel.legend(frameon=False, fontsize=SMALL, loc="upper left")
            else:
                panel.set_xlabel("pushes (thousands)", fontsize=SMALL)
        panels[3 * row].set_ylabel(label, fontsize=NORMAL)
    panels[0].set_ylim(0.0, LEGEND_ROOM * panels[0].get_ylim()[1])
    panels[3].set_ylim(0.0, 1.0)
    note_seeds(figure, "PPO on fixed-2", min(len(runs[variant]) for variant in VARIANTS))
    return figure


FIGURE = PaperFigure("fig3", "State, action and reward: proposed and baseline", VARIANTS,
                     measure, draw)  # fmt: skip
