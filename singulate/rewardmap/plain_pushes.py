"""The plain algorithm: one simulated push for every start that can move something."""

import functools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.engine import Batch, Engine, TaskResult
from singulate.geometry import Direction, Poses, Push, Workspace
from singulate.rewardmap.algorithm import Cancelled, LevelUpdate
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.reach import blocked_starts, reaching_starts
from singulate.rewardmap.request import RewardMapRequest
from singulate.rewards import make_reward

PUSHES_PER_TASK = 3
"""Some 20 ms of work: short enough to stop at once, long enough to be worth a message."""
IDLE_PUSHES_PER_TASK = 100
"""Starts in a task of an exact map, where few pushes move anything."""
_POLL_S = 0.02
_INSIDE = 1e6
"""Added to a distance [px] it makes a key of its own, and leaves all of its digits."""

FloatMap = npt.NDArray[np.float32]
Cells = npt.NDArray[np.int64]
"""Flat indices into a (4, H, W) map, (N,)."""


class PushTasks(NamedTuple):
    """Pushes on one scene, to be simulated in one go."""

    request: RewardMapRequest
    resolution: int
    cells: Cells


def plain_pushes(
    request: RewardMapRequest, resolution: int, engine: Engine, cancelled: Cancelled
) -> Iterator[LevelUpdate]:
    """See `LevelAlgorithm`: every value is what the environment pays for that push."""
    tool = functools.partial(Prober, request.goal_separation, request.exact)
    values = np.full((len(Direction), resolution, resolution), np.nan, np.float32)
    if not request.exact:
        surveys = engine.submit(survey, [(request, resolution)], tool)
        for result in results_until(surveys, cancelled):
            values = result.value.copy()
    if cancelled():
        return
    chunks = split(np.flatnonzero(np.isnan(values)), request.exact)
    yield LevelUpdate(values.copy(), 0.0 if chunks else 1.0)
    tasks = [PushTasks(request, resolution, chunk) for chunk in chunks]
    results = results_until(engine.submit(simulate, tasks, tool), cancelled)
    for num_done, result in enumerate(results, start=1):
        values.reshape(-1)[chunks[result.index]] = result.value
        yield LevelUpdate(values.copy(), num_done / len(chunks))


def split(cells: Cells, is_exact: bool) -> list[Cells]:
    """Chunks of cells that lie far apart, so that the whole map fills evenly."""
    size = IDLE_PUSHES_PER_TASK if is_exact else PUSHES_PER_TASK
    num_chunks = -(-cells.size // size)
    return [cells[i::num_chunks] for i in range(num_chunks)]


def survey(prober: Prober, task: tuple[RewardMapRequest, int]) -> FloatMap:
    """Rewards of all pushes that move nothing, NaN elsewhere, float32 (4, H, W).

    What such a push is paid depends only on the distance-map value at its start and on whether it
    starts inside a block, so each combination is scored once.
    """
    request, resolution = task
    poses, workspace = request.poses, prober.workspace
    grid = (workspace, resolution, prober.pusher_side)
    is_inside = np.broadcast_to(blocked_starts(poses, *grid), (4, resolution, resolution))
    is_reaching = reaching_starts(poses, *grid)
    distances = _distances(prober, poses, resolution)
    keys = distances.astype(np.float64) + _INSIDE * is_inside
    _, firsts, inverse = np.unique(keys, return_index=True, return_inverse=True)
    reward = make_reward(request.reward)
    rewards = [
        reward.total(
            prober.idle_terms(
                poses, cell_push(workspace, resolution, int(cell)), bool(is_inside.flat[cell])
            ),
            request.num_pushes,
        )
        for cell in firsts
    ]
    values = np.array(rewards, np.float32)[inverse].reshape(is_reaching.shape)
    values[is_reaching & ~is_inside] = np.nan
    return values


def simulate(prober: Prober, task: PushTasks) -> FloatMap:
    """Rewards of pushes by simulation, float32 (N,)."""
    request = task.request
    reward = make_reward(request.reward)
    return np.array(
        [
            reward.total(
                prober.try_push(
                    request.poses, cell_push(prober.workspace, task.resolution, int(cell))
                ),
                request.num_pushes,
            )
            for cell in task.cells
        ],
        np.float32,
    )


def cell_push(workspace: Workspace, resolution: int, cell: int) -> Push:
    """The push that a flat index into a (4, H, W) map stands for."""
    direction, rest = divmod(cell, resolution * resolution)
    row, col = divmod(rest, resolution)
    start = workspace.row_col_to_xy(row, col, resolution)
    return Push.cardinal(start, Direction(direction), workspace.push_length)


def _distances(prober: Prober, poses: Poses, resolution: int) -> FloatMap:
    """Distance-map value at each start, (4, H, W) [px]."""
    distance_map = prober.look(poses).distance_map
    columns_x, rows_y = prober.workspace.cell_axes(resolution)
    rows = [prober.workspace.xy_to_row_col(0.0, y)[0] for y in rows_y.tolist()]
    cols = [prober.workspace.xy_to_row_col(x, 0.0)[1] for x in columns_x.tolist()]
    return np.broadcast_to(distance_map[np.ix_(rows, cols)], (4, resolution, resolution))


def results_until(batch: Batch[FloatMap], cancelled: Cancelled) -> Iterator[TaskResult[FloatMap]]:
    """Results as they come; at the end, or once cancelled, the rest of the batch is dropped."""
    try:
        while not batch.is_done and not cancelled():
            result = batch.poll(_POLL_S)
            if result is not None:
                yield result
    finally:
        batch.cancel()
