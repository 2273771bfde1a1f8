"""Fig. 4: reward definitions, among them r_Start for the first 40,000 pushes alone."""

from typing import TYPE_CHECKING

from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.style import (
    BLUE,
    GREEN,
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
from singulate.rewards.presets import NUM_PRETRAINING_PUSHES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LINES = {
    "ppo-fixed-2": ("Eq. 7: $r_{Dist}$ + $r_{Start}$ always", BLUE),
    "ppo-fixed-2-pretrained": ("$r_{Dist}$ + $r_{Start}$ (pretrained)", GREEN),
    "ppo-fixed-2-separation": ("$r_{Dist}$ alone", ORANGE),
}
"""By variant: its name in the figure, and its colour."""
ROWS = {"reward": "reward by Eq. 7", "success": "success"}


def measure(sources: Sources) -> Data | None:
    """Curves of every seed; None before each variant has one."""
    runs = summarise(LINES, sources)
    schedule = {"scenario": "fixed-2", "num_pretraining_pushes": NUM_PRETRAINING_PUSHES}
    return {**schedule, "runs": runs} if all(runs.values()) else None


def draw(data: Data) -> "Figure":
    """Reward on the left, success on the right."""
    figure, panels = new_figure(1, 2, 2.8)
    runs = data["runs"]
    longest = max(run["num_steps"] for variant in LINES for run in runs[variant])
    for panel, (key, label) in zip(panels, ROWS.items(), strict=True):
        quiet_axes(panel)
        for variant, (name, colour) in LINES.items():
            draw_band(panel, *stacked(runs[variant], key), colour, name)
        panel.set_xlabel("pushes (thousands)", fontsize=SMALL)
        panel.set_ylabel(label, fontsize=NORMAL)
        if longest > data["num_pretraining_pushes"]:
            panel.axvline(data["num_pretraining_pushes"] / 1000.0, color="0.4", lw=0.8, ls=":")
    panels[0].set_ylim(bottom=0.0)
    panels[1].set_ylim(0.0, 1.0)
    figure.legend(
        *panels[0].get_legend_handles_labels(),
        loc="outside upper center",
        ncols=3,
        frameon=False,
        fontsize=SMALL,
    )
    num_seeds = min(len(runs[variant]) for variant in LINES)
    note_seeds(figure, "PPO on fixed-2", num_seeds, "; dotted: pretraining ends")
    return figure


FIGURE = PaperFigure("fig4", "Reward definitions with and without pretraining", tuple(LINES),
                     measure, draw)  # fmt: skip
