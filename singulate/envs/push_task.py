"""One push on one table, seen and rewarded: what environments, reward maps and the page share."""

from dataclasses import dataclass

from singulate.geometry import Layout, Poses, Push, Workspace
from singulate.perception import Percept, perceive
from singulate.rewards import Transition, reward_terms
from singulate.simulation import PushOutcome, Scene


@dataclass(frozen=True)
class PushResult:
    """A push and what came of it.

    Attributes:
        push: What was executed.
        before: What the camera saw before.
        after: What it saw afterwards.
        outcome: What happened on the table.
        terms: The unweighted r of each reward term by name.
        is_success: Whether every pair of blocks is apart.
    """

    push: Push
    before: Percept
    after: Percept
    outcome: PushOutcome
    terms: dict[str, float]
    is_success: bool


class PushTask:
    """A scene under a camera, with the paper's reward terms.

    Args:
        workspace: The square that the table covers.
        goal_separation: d_goal of Eq. 2 [m].
        exact: See `Scene`.
    """

    def __init__(
        self,
        workspace: Workspace | None = None,
        goal_separation: float = 0.1,
        exact: bool = False,
    ) -> None:
        self.workspace = workspace or Workspace()
        self.goal_separation = goal_separation
        self.scene = Scene(self.workspace, exact=exact)
        self._percept: Percept | None = None

    @property
    def percept(self) -> Percept:
        """What the camera sees of the scene at rest."""
        if self._percept is None:
            self._percept = perceive(self.scene.photograph_blocks(), self.workspace)
        return self._percept

    @property
    def num_blocks(self) -> int:
        """Blocks that the task is about, also those that have fallen off."""
        return len(self.scene.poses)

    def place(self, layout: Layout) -> None:
        """Clear the table and put up blocks."""
        self.scene.place(layout)
        self._percept = None

    def restore(self, poses: Poses) -> None:
        """Return to a scene at rest.

        Raises:
            InvalidValueError: If a value is not finite.
        """
        self.scene.restore(poses)
        self._percept = None

    def execute(self, push: Push) -> PushResult:
        """Push, look again and score.

        Raises:
            SimulationError: If the physics went wrong; the scene is as before the push.
        """
        before = self.percept
        return self.score(push, before, self.scene.push(push))

    def score(self, push: Push, before: Percept, outcome: PushOutcome) -> PushResult:
        """Look again and score a push that the scene has just executed."""
        if outcome.is_touching or self.scene.exact:
            self._percept = None
        after = self.percept
        terms = reward_terms(
            Transition(
                before=before,
                push=push,
                after=after,
                is_inside=outcome.is_blocked,
                num_blocks=self.num_blocks,
                goal_separation=self.goal_separation,
                workspace=self.workspace,
            )
        )
        return PushResult(push, before, after, outcome, terms, terms["success"] > 0.0)

    def close(self) -> None:
        """Release the physics engine."""
        self.scene.close()
