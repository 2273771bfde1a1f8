"""The reward-map process: computes the reward of every push, coarse first, until told otherwise."""

from app.processes.pipes import Pipe
from app.processes.reward_map_messages import (
    CancelRewardMap,
    ComputeRewardMap,
    RewardMapProblem,
    RewardMapUpdate,
)
from singulate.engine import LocalEngine
from singulate.exceptions import SingulateError
from singulate.rewardmap import RewardMapRequest, refine_levels

_NICENESS = 5
"""Of the workers, on top of this process's own."""


def run_reward_maps(connection: Pipe, num_workers: int) -> None:
    """Serve reward maps until the pipe is closed.

    Args:
        connection: Pipe to the laboratory; see `reward_map_messages`.
        num_workers: Processes that push in parallel.

    Raises:
        EngineError: If workers cannot be started; the supervisor tries again with a new process.
    """
    with LocalEngine(num_workers, niceness=_NICENESS) as engine:
        while True:
            question = connection.recv()
            if isinstance(question, ComputeRewardMap):
                _compute(connection, question, engine)
            else:
                assert isinstance(question, CancelRewardMap)


def _compute(connection: Pipe, question: ComputeRewardMap, engine: LocalEngine) -> None:
    """Send what is known until the map is complete or any message arrives."""
    try:
        request = RewardMapRequest(question.poses)
        for reward_map in refine_levels(request, engine, cancelled=connection.poll):
            connection.send(
                RewardMapUpdate(
                    question.version,
                    reward_map.values,
                    reward_map.resolution,
                    reward_map.progress,
                )
            )
    except SingulateError as error:
        if engine.has_failed:
            raise
        connection.send(RewardMapProblem(question.version, str(error)))
