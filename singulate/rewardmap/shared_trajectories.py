"""The fast algorithm: all starts on one line share the simulation of their pushes."""

import functools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.engine import Engine
from singulate.geometry import Direction
from singulate.rewardmap.algorithm import Cancelled, LevelUpdate
from singulate.rewardmap.plain_pushes import Cells, FloatMap, cell_push, results_until, survey
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.request import RewardMapRequest
from singulate.rewards import make_reward

LINES_PER_TASK = 4
"""The scene is put up once a task; some 50 ms of work still stop and spread soon enough."""


class LinesTask(NamedTuple):
    """Pushes of one direction whose starts lie on a few lines."""

    request: RewardMapRequest
    resolution: int
    lines: list[Cells]


def shared_trajectories(
    request: RewardMapRequest, resolution: int, engine: Engine, cancelled: Cancelled
) -> Iterator[LevelUpdate]:
    """See `LevelAlgorithm`: values as of `plain_pushes`, but for what 1 mm of a start changes."""
    tool = functools.partial(Prober, request.goal_separation)
    values = np.full((len(Direction), resolution, resolution), np.nan, np.float32)
    for result in results_until(engine.submit(survey, [(request, resolution)], tool), cancelled):
        values = result.value.copy()
    if cancelled():
        return
    lines = split_into_lines(np.isnan(values))
    num_tasks = -(-len(lines) // LINES_PER_TASK)
    tasks = [LinesTask(request, resolution, lines[i::num_tasks]) for i in range(num_tasks)]
    yield LevelUpdate(values.copy(), 0.0 if tasks else 1.0)
    results = results_until(engine.submit(simulate_lines, tasks, tool), cancelled)
    for num_done, result in enumerate(results, start=1):
        values.reshape(-1)[np.concatenate(tasks[result.index].lines)] = result.value
        yield LevelUpdate(values.copy(), num_done / num_tasks)


def split_into_lines(is_open: npt.NDArray[np.bool_]) -> list[Cells]:
    """Flat indices of the cells to compute, bool (4, H, W), by direction and line of motion."""
    cells = np.arange(is_open.size).reshape(is_open.shape)
    lines = []
    for direction in Direction:
        is_vertical = direction.vector[0] == 0.0
        opened, indices = is_open[direction], cells[direction]
        if is_vertical:
            opened, indices = opened.T, indices.T
        lines += [index[mask] for mask, index in zip(opened, indices, strict=True) if mask.any()]
    return lines


def simulate_lines(prober: Prober, task: LinesTask) -> FloatMap:
    """Rewards of the pushes of a few lines, line after line, float32 (N,)."""
    request = task.request
    reward = make_reward(request.reward)
    lines = [
        [cell_push(prober.workspace, task.resolution, int(cell)) for cell in line]
        for line in task.lines
    ]
    terms = prober.try_lines(request.poses, lines)
    return np.array([reward.total(each, request.num_pushes) for each in terms], np.float32)
