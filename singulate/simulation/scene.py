"""The live table: blocks at rest, pushes, and the camera above."""

import math
from collections.abc import Generator
from types import TracebackType
from typing import Self

import numpy as np
import numpy.typing as npt

from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import CameraFrame, Layout, Poses, Push, Workspace, standing_pose
from singulate.simulation.approach import free_length, is_blocked
from singulate.simulation.camera import OverheadCamera, picture
from singulate.simulation.fallen import is_fallen
from singulate.simulation.outcome import PushFrame, PushOutcome
from singulate.simulation.physics import Physics
from singulate.simulation.pixel_window import window_of
from singulate.simulation.push_simulation import simulate_push
from singulate.simulation.schedule import PusherSchedule
from singulate.simulation.stage import Stage
from singulate.simulation.world import World


class Scene:
    """A table with blocks, one pusher and one camera.

    The outcome of a push is a pure function of the blocks' poses and the push: the same bits
    whatever happened before, in whichever process.

    Args:
        workspace: The square that the table covers.
        physics: Physical constants.
        exact: Whether to start Bullet anew for every push, to simulate all of its steps, and to
            draw the table in every picture. Otherwise what cannot move a block is left out: pushes
            past all blocks, and of the others the free approach and, once the blocks lie still,
            the retreat.
    """

    def __init__(
        self,
        workspace: Workspace | None = None,
        physics: Physics | None = None,
        exact: bool = False,
    ) -> None:
        self.workspace = workspace or Workspace()
        self.physics = physics or Physics()
        self.exact = exact
        self._world = World(self.workspace, self.physics, is_kept=not exact)
        self._stage: Stage | None = None
        self._camera = OverheadCamera(self.workspace)
        self._poses: Poses = ()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Release the physics engine."""
        self._world.close()
        if self._stage is not None:
            self._stage.close()

    @property
    def poses(self) -> Poses:
        """The blocks at rest; during a push, still those from before it."""
        return self._poses

    def place(self, layout: Layout) -> None:
        """Clear the table and put up blocks."""
        self.restore(tuple(standing_pose(block) for block in layout))

    def restore(self, poses: Poses) -> None:
        """Return to blocks at rest that were read from `poses` before.

        Raises:
            InvalidValueError: If a value is not finite.
        """
        for i, pose in enumerate(poses):
            if not all(map(math.isfinite, (*pose.position, *pose.quaternion, pose.side))):
                raise InvalidValueError(f"poses[{i}]", pose, "finite numbers")
        self._poses = poses

    def is_blocked(self, push: Push) -> bool:
        """Whether the pusher, lowered at the start, would land on a block."""
        return is_blocked(self._poses, push, self.physics.pusher_side)

    def touches(self, push: Push) -> bool:
        """Whether the pusher comes close enough to a block to move it."""
        return self._clear_length(push) < push.length

    def push(self, push: Push) -> PushOutcome:
        """Execute a push and let everything come to rest.

        Raises:
            SimulationError: If the physics went wrong; the blocks are as before the push.
        """
        if self.is_blocked(push):
            return PushOutcome(is_blocked=True)
        clear_length = self._clear_length(push)
        if clear_length >= push.length and not self.exact:
            return PushOutcome()
        steps = self._simulate(push, clear_length, is_watched=False)
        while True:
            try:
                next(steps)
            except StopIteration as stop:
                outcome: PushOutcome = stop.value
                return outcome

    def push_steps(self, push: Push) -> Generator[PushFrame, None, PushOutcome]:
        """Execute a push step by step, for watching; the result is the same as `push`.

        Yields:
            The moment after each time step, also of a push that touches nothing; a blocked one
            yields nothing.

        Raises:
            SimulationError: As `push`.
        """
        if self.is_blocked(push):
            return PushOutcome(is_blocked=True)
        clear_length = self._clear_length(push)
        is_simulated = clear_length < push.length or self.exact
        schedule = PusherSchedule(push, self.physics)
        num_still = schedule.num_steps
        if is_simulated:
            num_still = self._num_clear_steps(schedule, clear_length)
        for position in schedule.path(0, num_still):
            yield PushFrame(self._poses, (*position, push.yaw))
        if not is_simulated:
            return PushOutcome(num_steps=num_still)
        steps = self._simulate(push, clear_length, is_watched=True)
        while True:
            try:
                next(steps)
            except StopIteration as stop:
                outcome: PushOutcome = stop.value
                return outcome
            yield PushFrame(self._world.block_poses(), self._world.pusher_pose())

    def photograph(self) -> CameraFrame:
        """What the camera sees of the blocks at rest."""
        return self._camera.photograph(self._shown_stage().client)

    def photograph_blocks(self) -> CameraFrame:
        """What the camera sees of the blocks at rest; unless `exact`, its colours are left white.

        Drawing the table takes most of a picture's time. It is flat, so its depth is filled in.
        """
        if self.exact:
            return self.photograph()
        self._world.show(self._poses)
        window = window_of(self._poses, self.workspace)
        return self._camera.photograph_window(self._world.client, window)

    def picture(self, width: int = 480, height: int = 360) -> npt.NDArray[np.uint8]:
        """A view of the table for people, uint8 (height, width, 3)."""
        return picture(self._shown_stage().client, width, height, self.workspace.half_length)

    def _shown_stage(self) -> Stage:
        if self._stage is None:
            self._stage = Stage(self.workspace)
        self._stage.show(self._poses)
        return self._stage

    def _clear_length(self, push: Push) -> float:
        return free_length(self._poses, push, self.physics.pusher_side)

    def _num_clear_steps(self, schedule: PusherSchedule, clear_length: float) -> int:
        """Steps at the beginning that are not simulated with the pusher in them."""
        return 0 if self.exact else schedule.num_clear_steps(clear_length)

    def _simulate(
        self, push: Push, clear_length: float, *, is_watched: bool
    ) -> Generator[None, None, PushOutcome]:
        schedule = PusherSchedule(push, self.physics)
        num_clear_steps = self._num_clear_steps(schedule, clear_length)
        self._world.build(self._poses)
        try:
            num_settle_steps, is_settled = yield from simulate_push(
                self._world,
                schedule,
                num_clear_steps,
                is_exact=self.exact,
                is_watched=is_watched,
            )
            after = self._world.checked_poses()
        except SimulationError:
            self._world.discard()
            raise
        before, self._poses = self._poses, after
        return PushOutcome(
            is_touching=clear_length < push.length,
            is_settled=is_settled,
            fallen=tuple(
                i
                for i, (old, new) in enumerate(zip(before, self._poses, strict=True))
                if is_fallen(new) and not is_fallen(old)
            ),
            moved=max(
                math.dist(old.position, new.position)
                for old, new in zip(before, self._poses, strict=True)
            ),
            num_steps=schedule.num_steps + num_settle_steps,
        )
