"""The ceiling of an action space: the share of scenes that some push of a grid solves."""

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from singulate.agents.config_fields import check_int, check_number
from singulate.engine import Engine
from singulate.envs import scene_seed
from singulate.evaluation import wilson_interval
from singulate.geometry import Poses, Push, Workspace, standing_pose
from singulate.rewardmap.plain_pushes import cell_push
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.reach import blocked_starts, reaching_starts
from singulate.rewardmap.request import MAX_RESOLUTION
from singulate.rewardmap.shared_trajectories import split_into_lines
from singulate.simulation import make_scenario


@dataclass(frozen=True)
class CeilingConfig:
    """What is searched.

    Attributes:
        scenario: Recipe of the scenes.
        grid: Starts along each side, at the centres of equal cells; four directions each. 10 is
            the paper's discretisation (section 5.4).
        num_scenes: How many scenes.
        seed: Decides them: the same ones that an evaluation of this seed uses.
        goal_separation: d_goal of Eq. 2 [m].

    Raises:
        InvalidValueError: If a value is not allowed.
    """

    scenario: str
    grid: int = 10
    num_scenes: int = 1000
    seed: int = 7
    goal_separation: float = 0.1

    def __post_init__(self) -> None:
        make_scenario(self.scenario)
        check_int("grid", self.grid, 1, MAX_RESOLUTION)
        check_int("scenes", self.num_scenes, 1)
        check_int("seed", self.seed, 0, 2**63 - 1)
        check_number("goal_separation", self.goal_separation, 1e-3, 1.0)


@dataclass(frozen=True)
class Ceiling:
    """How many scenes a single push of the grid can solve.

    Attributes:
        num_scenes: Scenes searched.
        num_solvable: Scenes with a push after which all blocks are apart.
        interval: 95 % Wilson interval of their share.
    """

    num_scenes: int
    num_solvable: int
    interval: tuple[float, float]

    @property
    def share(self) -> float:
        """Share of solvable scenes."""
        return self.num_solvable / self.num_scenes

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "num_scenes": self.num_scenes,
            "num_solvable": self.num_solvable,
            "share": self.share,
            "interval_95": list(self.interval),
        }


class SceneTask(NamedTuple):
    """One scene of a search, by its number; a task of an engine."""

    config: CeilingConfig
    number: int


def measure_ceiling(
    config: CeilingConfig, engine: Engine, on_progress: Callable[[int], None] | None = None
) -> Ceiling:
    """Search scene after scene; the result does not depend on the engine.

    Shared trajectories suggest pushes, which count once the plain push succeeds; where none does,
    every push that reaches a block is made plainly. So the answer is that of the environment's own
    pushes alone. Scenarios of several pushes are searched for a single one too.

    Args:
        config: What to search.
        engine: Where pushes are simulated.
        on_progress: Called with the number of finished scenes.

    Raises:
        EngineError: If a scene failed or workers cannot be started.
    """
    total = config.num_scenes
    tasks = [SceneTask(config, index) for index in range(total)]
    num_solvable = 0
    batch = engine.submit(is_solvable, tasks, functools.partial(Prober, config.goal_separation))
    for num_done, result in enumerate(batch, start=1):
        num_solvable += result.value
        if on_progress is not None:
            on_progress(num_done)
    return Ceiling(total, num_solvable, wilson_interval(num_solvable, total))


def is_solvable(prober: Prober, task: SceneTask) -> bool:
    """Whether some push solves a scene."""
    poses = evaluation_poses(task.config, task.number)
    return winning_push(prober, poses, task.config.grid) is not None


def evaluation_poses(config: CeilingConfig, index: int) -> Poses:
    """The blocks of one evaluation scene, at rest."""
    rng = np.random.default_rng(scene_seed("evaluation", config.seed, index))
    layout = make_scenario(config.scenario).sample(rng, Workspace())
    return tuple(standing_pose(block) for block in layout)


def winning_push(prober: Prober, poses: Poses, grid: int) -> Push | None:
    """A push from the centre of a cell that singulates the scene; None where there is none."""
    about = (poses, prober.workspace, grid, prober.pusher_side)
    lines = [
        [cell_push(prober.workspace, grid, int(cell)) for cell in line]
        for line in split_into_lines(reaching_starts(*about) & ~blocked_starts(*about))
    ]
    for line in lines:
        for push, terms in zip(line, prober.try_lines(poses, [line]), strict=True):
            if terms["success"] > 0.0 and _solves(prober, poses, push):
                return push
    return next((push for line in lines for push in line if _solves(prober, poses, push)), None)


def _solves(prober: Prober, poses: Poses, push: Push) -> bool:
    return prober.try_push(poses, push)["success"] > 0.0
