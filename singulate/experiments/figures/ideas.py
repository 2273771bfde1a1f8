"""The paper's ideas for future work (section 6), tried: learning curves and a verdict on each."""

from typing import TYPE_CHECKING

from singulate.experiments.claims.evidence import Evidence
from singulate.experiments.claims.registry import judge_ideas
from singulate.experiments.claims.table import claims_page
from singulate.experiments.figures.paper_figure import Data, PaperFigure, Sources
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.style import (
    BLUE,
    GREEN,
    GREY,
    NORMAL,
    ORANGE,
    PINK,
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

LINES = {
    "ppo-random-2-short": ("one Gaussian (the paper's PPO)", BLUE),
    "mixture-ppo-1-random-2": ("one Gaussian, our network", GREY),
    "mixture-ppo-random-2": ("mixture of Gaussians", ORANGE),
    "fourier-ppo-random-2": ("Fourier density", GREEN),
    "multimodal-ppo-random-2": ("cells (multimodal-ppo)", PINK),
}
"""By variant: its name in the figure, and its colour; a further idea is one line."""
ROWS = {"reward": "reward by Eq. 7", "success": "success"}
HEAD = """# The paper's ideas for future work

*Interactive Segmentation using Object Singulation*, section 6, idea by idea. This page is written
by `singulate reproduce ideas` from `ideas.json` beside it. Numbers are medians over seeds with
their range; success is a share of 1. The rule of each verdict is code, in
`singulate/experiments/claims/`. With fewer than three seeds nothing is judged. All but the paper's
PPO share one convolutional network, so that among them only the density differs.
"""


def measure(sources: Sources) -> Data | None:
    """Curves of every seed, and the verdicts; None before each variant has one."""
    runs = summarise(LINES, sources)
    if not all(runs.values()):
        return None
    claims = [claim.to_dict() for claim in judge_ideas(Evidence(runs))]
    return {"scenario": "random-2", "runs": runs, "claims": claims}


def draw(data: Data) -> "Figure":
    """Reward on the left, success on the right."""
    figure, panels = new_figure(1, 2, 3.0)
    runs = data["runs"]
    for panel, (key, label) in zip(panels, ROWS.items(), strict=True):
        quiet_axes(panel)
        for variant, (name, colour) in LINES.items():
            draw_band(panel, *stacked(runs[variant], key), colour, name)
        panel.set_xlabel("pushes (thousands)", fontsize=SMALL)
        panel.set_ylabel(label, fontsize=NORMAL)
    panels[0].set_ylim(bottom=0.0)
    panels[1].set_ylim(0.0, 1.0)
    figure.legend(
        *panels[0].get_legend_handles_labels(),
        loc="outside upper center",
        ncols=3,
        frameon=False,
        fontsize=SMALL,
    )
    note_seeds(figure, "PPO on random-2", min(len(runs[variant]) for variant in LINES))
    return figure


def page(data: Data, plan: Plan) -> str:
    """The verdicts as a page."""
    evidence = Evidence(data["runs"])
    return claims_page(judge_ideas(evidence), evidence, plan, HEAD)


FIGURE = PaperFigure("ideas", "The ideas of section 6", tuple(LINES), measure, draw, page)
