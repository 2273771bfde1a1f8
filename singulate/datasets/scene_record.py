"""One scene of a data set: the pure work of one task of an engine."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.datasets.manifest import DatasetConfig
from singulate.envs import scene_seed
from singulate.geometry import Direction, Workspace, standing_pose
from singulate.outcomes import OUTCOMES
from singulate.rewardmap import RewardMapRequest
from singulate.rewardmap.plain_pushes import cell_push, survey
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.reach import blocked_starts
from singulate.rewardmap.shared_trajectories import split_into_lines
from singulate.rewards import make_reward
from singulate.simulation import make_scenario


class SceneTask(NamedTuple):
    """A scene of a data set by its number."""

    config: DatasetConfig
    number: int


class SceneRecord(NamedTuple):
    """What a data set holds of a scene, in the types that it is stored in.

    Attributes:
        seed: Its seed, for `Env.reset`.
        blocks: float64 (N, 4): x, y, side [m] and yaw [rad].
        mask: What the camera sees, bool (64, 64).
        reward_map: float16 (4, R, R); directions up, right, down, left, row 0 is +y.
        outcomes: What becomes of each push, an index into `OUTCOMES`, uint8 (4, R, R): ``empty``
            where the footprint meets no block, else ``success``, ``inside`` or ``not_separated``.
    """

    seed: int
    blocks: npt.NDArray[np.float64]
    mask: npt.NDArray[np.bool_]
    reward_map: npt.NDArray[np.float16]
    outcomes: npt.NDArray[np.uint8]


def record_scene(prober: Prober, task: SceneTask) -> SceneRecord:
    """Value every push on a scene, by shared trajectories."""
    config, size = task.config, task.config.resolution
    seed = scene_seed("dataset", config.seed, task.number)
    layout = make_scenario(config.scenario).sample(np.random.default_rng(seed), Workspace())
    poses = tuple(standing_pose(block) for block in layout)
    request = RewardMapRequest(poses, size, config.goal_separation, config.reward)
    values = survey(prober, (request, size))
    inside = blocked_starts(poses, prober.workspace, size, prober.pusher_side)
    outcomes = np.full((len(Direction), size, size), OUTCOMES.index("empty"), np.uint8)
    outcomes[:, inside] = OUTCOMES.index("inside")
    lines = split_into_lines(np.isnan(values))
    if lines:
        pushes = [[cell_push(prober.workspace, size, int(cell)) for cell in row] for row in lines]
        terms = prober.try_lines(poses, pushes)
        reward, cells = make_reward(config.reward), np.concatenate(lines)
        values.reshape(-1)[cells] = [reward.total(each) for each in terms]
        outcomes.reshape(-1)[cells] = [OUTCOMES.index(_outcome(each)) for each in terms]
    return SceneRecord(
        seed=seed,
        blocks=np.array([(block.x, block.y, block.side, block.yaw) for block in layout]),
        mask=prober.look(poses).mask.copy(),
        reward_map=values.astype(np.float16),
        outcomes=outcomes,
    )


def _outcome(terms: dict[str, float]) -> str:
    if terms["success"] > 0.0:
        return "success"
    return "inside" if terms["inside"] > 0.0 else "not_separated"
