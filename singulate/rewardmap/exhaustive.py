"""Exhaustive search: what somebody would do who may try every push on the table first."""

import numpy as np

from singulate.agents.policy import FloatMap
from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Poses, Push
from singulate.rewardmap.plain_pushes import cell_push
from singulate.rewardmap.prober import Prober
from singulate.rewardmap.reach import blocked_starts, reaching_starts
from singulate.rewardmap.shared_trajectories import split_into_lines
from singulate.rewards import make_reward

GRID = 16
"""Starts along each side; on 10, the paper's, every sixth scene of random-3 has no solution."""
NUM_CHECKED = 8
"""Best candidates of the fast search that are made as plain pushes before one is chosen."""


class ExhaustivePolicy:
    """Makes the push of the highest reward of Eq. 7 among those of a grid.

    No policy but a yardstick: it sees the true poses and simulates every push that meets a block.

    Args:
        grid: Starts along each side.
    """

    kind = "exhaustive"
    observation = "distance_map"
    is_random = False

    def __init__(self, grid: int = GRID) -> None:
        self.grid = grid
        self._reward = make_reward("paper")
        self._prober: tuple[float, Prober] | None = None

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """Refused, because an observation is not enough.

        Raises:
            InvalidValueError: Always.
        """
        raise InvalidValueError("policy", self.kind, "a policy that needs no true poses")

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """None: it tries instead."""
        return None

    def act_on(self, poses: Poses, goal_separation: float) -> Push:
        """The best push; where none meets a block, one that does nothing."""
        prober = self._prober_for(goal_separation)
        sides = (poses, prober.workspace, self.grid, prober.pusher_side)
        lines = [
            [cell_push(prober.workspace, self.grid, int(cell)) for cell in line]
            for line in split_into_lines(reaching_starts(*sides) & ~blocked_starts(*sides))
        ]
        if not lines:
            return Push.cardinal((0.0, 0.0), Direction.UP, prober.workspace.push_length)
        pushes = [push for line in lines for push in line]
        rewards = [self._reward.total(terms) for terms in prober.try_lines(poses, lines)]
        best = [pushes[int(i)] for i in np.argsort(rewards)[::-1][:NUM_CHECKED]]
        checked = [self._reward.total(prober.try_push(poses, push)) for push in best]
        return best[int(np.argmax(checked))]

    def close(self) -> None:
        """Release the physics engine."""
        if self._prober is not None:
            self._prober[1].close()
            self._prober = None

    def _prober_for(self, goal_separation: float) -> Prober:
        if self._prober is None or self._prober[0] != goal_separation:
            self.close()
            self._prober = (goal_separation, Prober(goal_separation))
        return self._prober[1]
