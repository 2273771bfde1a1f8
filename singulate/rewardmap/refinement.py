"""A reward map from coarse to fine."""

import time
from collections.abc import Callable, Iterator

import numpy as np
import numpy.typing as npt

from singulate.engine import Engine
from singulate.exceptions import SingulateError
from singulate.rewardmap.algorithm import Cancelled, LevelAlgorithm
from singulate.rewardmap.plain_pushes import plain_pushes
from singulate.rewardmap.request import RewardMapRequest
from singulate.rewardmap.reward_map import RewardMap
from singulate.rewardmap.shared_trajectories import shared_trajectories

COARSE_LEVELS = (8, 16)
"""Resolutions that are shown before the finest one; together they cost a tenth of 64 x 64."""

UPDATE_INTERVAL_S = 0.1
"""Partial maps do not follow each other faster than this."""


class RewardMapCancelledError(SingulateError):
    """The map was cancelled before it was complete."""

    def __init__(self) -> None:
        super().__init__("the reward map was cancelled")


def refinement_levels(resolution: int) -> tuple[int, ...]:
    """Resolutions in the order in which they are computed.

    Example:
        >>> refinement_levels(64)
        (8, 16, 64)
    """
    return (*(level for level in COARSE_LEVELS if level < resolution), resolution)


def refine_levels(
    request: RewardMapRequest,
    engine: Engine,
    cancelled: Cancelled = lambda: False,
    algorithm: LevelAlgorithm | None = None,
) -> Iterator[RewardMap]:
    """Compute a reward map, showing what is known on the way.

    Args:
        request: The scene and what to value.
        engine: Where the pushes are simulated.
        cancelled: Asked every 20 ms or so; True ends the iterator early.
        algorithm: How one level is computed; `plain_pushes` for an exact map and
            `shared_trajectories` otherwise where None.

    Yields:
        Each coarser level when it is complete, then the finest level, first filled up with the
        coarser one and refined in place; the last one is complete unless cancelled. The values do
        not depend on the number of workers.

    Raises:
        EngineError: If workers cannot be started or keep dying.
    """
    if algorithm is None:
        algorithm = plain_pushes if request.exact else shared_trajectories
    levels = refinement_levels(request.resolution)
    coarse = np.full((4, 1, 1), np.nan, np.float32)
    for level in levels:
        shown_at = -np.inf
        for update in algorithm(request, level, engine, cancelled):
            is_finest = level == request.resolution
            is_due = is_finest and time.monotonic() - shown_at >= UPDATE_INTERVAL_S
            if update.progress == 1.0 or (is_due and level != levels[0]):
                shown_at = time.monotonic()
                values = fill_from(coarse, update.values)
                progress = update.progress if is_finest else 0.0
                yield RewardMap(
                    values, progress, request.poses, request.reward, request.goal_separation
                )
        if cancelled():
            return
        coarse = update.values


def compute_reward_map(
    request: RewardMapRequest,
    engine: Engine,
    on_progress: Callable[[RewardMap], None] | None = None,
    cancelled: Cancelled = lambda: False,
    algorithm: LevelAlgorithm | None = None,
) -> RewardMap:
    """The complete reward map of a scene.

    Args:
        request: The scene and what to value.
        engine: Where the pushes are simulated.
        on_progress: Called with what is known so far.
        cancelled: Asked every 20 ms or so; True ends the work.
        algorithm: How one level is computed; `plain_pushes` for an exact map and
            `shared_trajectories` otherwise where None.

    Returns:
        The map at the requested resolution.

    Raises:
        RewardMapCancelledError: If it was cancelled.
        EngineError: If workers cannot be started or keep dying.
    """
    for reward_map in refine_levels(request, engine, cancelled, algorithm):
        if on_progress is not None:
            on_progress(reward_map)
        if reward_map.is_complete:
            return reward_map
    raise RewardMapCancelledError


def fill_from(
    coarse: npt.NDArray[np.float32], fine: npt.NDArray[np.float32]
) -> npt.NDArray[np.float32]:
    """A fine level whose unknown values are those of the coarse cells that hold their centres."""
    size = fine.shape[1]
    cells = ((np.arange(size) + 0.5) * coarse.shape[1] / size).astype(np.int64)
    return np.where(np.isnan(fine), coarse[:, cells][:, :, cells], fine)
