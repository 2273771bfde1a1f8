"""Tries pushes on a scene and takes each one back."""

from collections.abc import Sequence

from singulate.envs.push_task import PushTask
from singulate.exceptions import SimulationError
from singulate.geometry import Poses, Push, Workspace
from singulate.perception import Percept, Segmentation, segment
from singulate.rewards import TERMS, Transition, reward_terms
from singulate.simulation.shared_trajectory import LineEnd, SharedTrajectories


class Prober:
    """A worker's tool: one Bullet scene for all the pushes that it is asked about.

    Each answer is a pure function of the poses and the push, because a push is.

    Args:
        goal_separation: d_goal of Eq. 2 [m].
        exact: Whether to simulate every step of every push.
    """

    def __init__(self, goal_separation: float, exact: bool = False) -> None:
        self._task = PushTask(goal_separation=goal_separation, exact=exact)
        self._shared = SharedTrajectories(self._task.workspace, self._task.scene.physics)
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
        if outcome.is_blocked or not (outcome.is_touching or self._task.scene.exact):
            return self.idle_terms(poses, push, outcome.is_blocked)
        return self._task.score(push, before, outcome).terms

    def try_lines(self, poses: Poses, lines: Sequence[Sequence[Push]]) -> list[dict[str, float]]:
        """`try_push` for pushes whose starts lie on lines, by shared trajectories.

        Args:
            poses: The blocks at rest.
            lines: Pushes of one line each, at least one, none of which starts inside a block.

        Returns:
            The terms of each push, line after line.
        """
        self.look(poses)
        self._shared.place(poses)
        return [terms for line in lines for terms in self._try_line(poses, line)]

    def _try_line(self, poses: Poses, pushes: Sequence[Push]) -> list[dict[str, float]]:
        before = self.look(poses)
        ends = list(self._shared.ends(pushes))
        seen = {id(poses): before, **self._look_at_ends(ends, poses)}
        terms = [dict.fromkeys(TERMS, 0.0) for _ in pushes]
        for index, rest in ends:
            if rest is not None:  # otherwise paid nothing
                after = seen[id(rest)]
                terms[index] = self._terms(before, pushes[index], after, False, len(poses))
        return terms

    def _look_at_ends(self, ends: Sequence[LineEnd], poses: Poses) -> dict[int, Segmentation]:
        """What the camera sees of the ends at which something has moved, by the poses' `id`.

        Picture after picture, then image after image: the processor finds in its caches what one
        kind of work needs, which makes whole maps a tenth faster than end after end.
        """
        rests = {id(end.poses): end.poses for end in ends if end.poses is not poses}
        frames = {
            key: self._shared.photograph(rest) for key, rest in rests.items() if rest is not None
        }
        pixel = self.workspace.metres_per_pixel
        return {key: segment(frame, pixel) for key, frame in frames.items()}

    def idle_terms(self, poses: Poses, push: Push, is_inside: bool) -> dict[str, float]:
        """The unweighted reward terms of a push that moves nothing."""
        before = self.look(poses)
        return self._terms(before, push, before, is_inside, len(poses))

    def close(self) -> None:
        """Release the physics engine."""
        self._task.close()
        self._shared.close()

    def _terms(
        self, before: Percept, push: Push, after: Segmentation, is_inside: bool, num_blocks: int
    ) -> dict[str, float]:
        goal = self._task.goal_separation
        return reward_terms(
            Transition(before, push, after, is_inside, num_blocks, goal, self.workspace)
        )
