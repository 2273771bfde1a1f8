"""The reward-map process: computes the reward of every push, coarse first, until told otherwise."""

from collections.abc import Callable, Iterator

from app.processes.pipes import Pipe
from app.processes.reward_map_messages import (
    CancelRewardMap,
    ComputeRewardMap,
    RewardMapProblem,
    RewardMapUpdate,
)
from singulate.engine import LocalEngine
from singulate.exceptions import SingulateError
from singulate.rewardmap import RewardMap, RewardMapRequest, refine_levels
from singulate.rewardmap.refinement import COARSE_LEVELS

_COARSEST = COARSE_LEVELS[0]
_NICENESS = 15
"""Of the workers for the finer levels, on top of this process's own: they take what a training
leaves. The coarsest level is some 50 ms of work and has a worker of its own that does not stand
back and that never is busy with a scene that has passed."""


def run_reward_maps(connection: Pipe, num_workers: int) -> None:
    """Serve reward maps until the pipe is closed.

    Args:
        connection: Pipe to the laboratory; see `reward_map_messages`.
        num_workers: Processes that push in parallel for the finer levels.

    Raises:
        EngineError: If workers cannot be started; the supervisor tries again with a new process.
    """
    with (
        LocalEngine(1, niceness=0) as prompt,
        LocalEngine(num_workers, niceness=_NICENESS) as thorough,
    ):
        while True:
            question = connection.recv()
            if isinstance(question, ComputeRewardMap):
                _compute(connection, question, prompt, thorough)
            else:
                assert isinstance(question, CancelRewardMap)


def _compute(
    connection: Pipe, question: ComputeRewardMap, prompt: LocalEngine, thorough: LocalEngine
) -> None:
    """Send what is known until the map is complete or any message arrives."""
    try:
        for reward_map in _levels(question, prompt, thorough, connection.poll):
            is_coarsest = reward_map.resolution == _COARSEST
            connection.send(
                RewardMapUpdate(
                    question.version,
                    reward_map.values,
                    reward_map.resolution,
                    0.0 if is_coarsest else reward_map.progress,
                )
            )
    except SingulateError as error:
        if prompt.has_failed or thorough.has_failed:
            raise
        connection.send(RewardMapProblem(question.version, str(error)))


def _levels(
    question: ComputeRewardMap,
    prompt: LocalEngine,
    thorough: LocalEngine,
    cancelled: Callable[[], bool],
) -> Iterator[RewardMap]:
    yield from refine_levels(RewardMapRequest(question.poses, _COARSEST), prompt, cancelled)
    for reward_map in refine_levels(RewardMapRequest(question.poses), thorough, cancelled):
        if reward_map.resolution > _COARSEST:
            yield reward_map
