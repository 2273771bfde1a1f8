"""Tries pushes on a scene and takes each one back."""

from singulate.envs.push_task import PushTask
from singulate.exceptions import SimulationError
from singulate.geometry import Poses, Push, Workspace
from singulate.perception import Percept
from singulate.rewards import TERMS, Transition, reward_terms


class Prober:
    """A worker's tool: one Bullet scene for all the pushes that it is asked about.

    Each answer is a pure function of the poses and the push, because a push is.

    Args:
        goal_separation: d_goal of Eq. 2 [m].
    """

    def __init__(self, goal_separation: float) -> None:
        self._task = PushTask(goal_separation=goal_separation)
        self._poses: Poses | None = None
        self._before: Percept | None = None

    @property
    def workspace(self) -> Workspace:
        """The square that the table covers."""
        return self._task.workspace

    @property
    def pusher_side(self) -> float:
        """Width of the pusher [m]."""
        return self._task.scene.physics.pusher_side

    def look(self, poses: Poses) -> Percept:
        """What the camera sees of a scene at rest."""
        if self._before is None or poses != self._poses:
            self._task.restore(poses)
            self._poses, self._before = poses, self._task.percept
        return self._before

    def try_push(self, poses: Poses, push: Push) -> dict[str, float]:
        """The unweighted reward terms of a push, by name.

        A push at which the physics goes wrong is paid nothing, as in the environment.
        """
        before = self.look(poses)
        self._task.restore(poses)
        try:
            outcome = self._task.scene.push(push)
        except SimulationError:
            return dict.fromkeys(TERMS, 0.0)
        if not outcome.is_touching:
            return self.idle_terms(poses, push, outcome.is_blocked)
        return self._task.score(push, before, outcome).terms

    def idle_terms(self, poses: Poses, push: Push, is_inside: bool) -> dict[str, float]:
        """The unweighted reward terms of a push that moves nothing."""
        before = self.look(poses)
        goal = self._task.goal_separation
        return reward_terms(
            Transition(before, push, before, is_inside, len(poses), goal, self.workspace)
        )

    def close(self) -> None:
        """Release the physics engine."""
        self._task.close()
