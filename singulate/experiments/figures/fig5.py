"""Fig. 5: what a DQN expects of every push after 4,000 of them, beside the truth."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from singulate.agents.policy import HasQMap
from singulate.envs.push_task import PushTask
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
from singulate.geometry import Direction, Poses, Workspace, standing_pose
from singulate.rewardmap import RewardMapRequest, compute_reward_map
from singulate.simulation import make_scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure

VARIANT = "dqn-fixed-2-start"


def measure(sources: Sources) -> Data | None:
    """Q and true reward (4, 10, 10) of the one scene, for every finished seed; None without any."""
    from singulate.agents.loading import load_policy

    variant = VARIANTS[VARIANT]
    layout = make_scenario(variant.env.scenario).sample(np.random.default_rng(0), Workspace())
    poses = tuple(standing_pose(block) for block in layout)
    seeds: list[Any] = []
    truth: npt.NDArray[np.float32] = np.empty(0, np.float32)
    for cell in variant.cells(sources.plan):
        if not sources.store.has_run(cell):
            continue
        policy = load_policy(sources.store.run_dir(cell))
        assert isinstance(policy, HasQMap)
        values = policy.q_map(_distance_map(poses))
        if not truth.size:
            request = RewardMapRequest(poses, values.shape[-1], reward=variant.env.reward)
            truth = compute_reward_map(request, sources.engine).values
        seeds.append({"seed": cell.training.seed, "num_steps": cell.training.total_timesteps,
                      **_agreement(values, truth), "q_map": values.round(1).tolist()})  # fmt: skip
    if not seeds:
        return None
    return {"scenario": variant.env.scenario, "reward": variant.env.reward, "seeds": seeds,
            "directions": [direction.label for direction in Direction],
            "rewards": truth.round(1).tolist(), "blocks": outlines(poses)}  # fmt: skip


def draw(data: Data) -> "Figure":
    """The first seed's values above, the true rewards below."""
    first = data["seeds"][0]
    figure, panels = new_figure(2, 4, 3.35)
    rows = {f"Q, {first['num_steps']:,} pushes": first["q_map"], "true reward": data["rewards"]}
    high = max(np.array(first["q_map"]).max(), np.array(data["rewards"]).max())
    low = min(np.array(first["q_map"]).min(), np.array(data["rewards"]).min())
    for row, (label, maps) in enumerate(rows.items()):
        for column, values in enumerate(maps):
            panel = panels[4 * row + column]
            image = draw_map(panel, values, (low, high))
            draw_blocks(panel, data["blocks"])
            quiet_map(panel, f"push {data['directions'][column]}" if row == 0 else "")
        panels[4 * row].set_ylabel(label, fontsize=NORMAL)
    colour_bar(figure, image, panels, r"$300\,r_{Start} - 100\,r_{Inside}$")
    return figure


def _distance_map(poses: Poses) -> Any:
    task = PushTask()
    task.restore(poses)
    distances = task.percept.distance_map
    task.close()
    return distances


def _agreement(values: Any, truth: Any) -> dict[str, float]:
    """Correlation over all pushes, and what the push of the highest value gets of the best."""
    chosen = truth.flat[int(values.argmax())]
    return {
        "correlation": round(float(np.corrcoef(values.ravel(), truth.ravel())[0, 1]), 4),
        "share_of_best": round(float(chosen / truth.max()), 4),
    }


FIGURE = PaperFigure("fig5", "A DQN's values after 4,000 pushes", (VARIANT,), measure, draw)
