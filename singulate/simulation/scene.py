"""The live table: blocks at rest, pushes, and the camera above."""

import math
from collections.abc import Generator
from types import TracebackType
from typing import Self

import numpy as np
import numpy.typing as npt

from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import CameraFrame, Layout, Poses, Push, Workspace, standing_pose
from singulate.geometry.rectangle import Polygon, penetration
from singulate.simulation.camera import OverheadCamera, picture
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import (
    SWEEP_MARGIN,
    block_footprint,
    pusher_footprint,
    swept_footprint,
)
from singulate.simulation.outcome import PushFrame, PushOutcome
from singulate.simulation.physics import Physics
from singulate.simulation.pixel_window import window_of
from singulate.simulation.schedule import PusherSchedule
from singulate.simulation.settling import check_speeds, is_still, num_moving_steps, settle
from singulate.simulation.stage import Stage
from singulate.simulation.world import TopSpeeds, World

MAX_PUSHER_ERROR = 0.02
"""A pusher further than this from its target means that the physics went wrong [m]."""


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
        return self._meets(pusher_footprint(push, self.physics.pusher_side), 0.0)

    def touches(self, push: Push) -> bool:
        """Whether the pusher comes close enough to a block to move it."""
        return self._meets(swept_footprint(push, self.physics.pusher_side), -SWEEP_MARGIN)

    def push(self, push: Push) -> PushOutcome:
        """Execute a push and let everything come to rest.

        Raises:
            SimulationError: If the physics went wrong; the blocks are as before the push.
        """
        if self.is_blocked(push):
            return PushOutcome(is_blocked=True)
        is_touching = self.touches(push)
        if not (is_touching or self.exact):
            return PushOutcome()
        steps = self._simulate(push, is_touching)
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
        is_touching = self.touches(push)
        is_simulated = is_touching or self.exact
        schedule = PusherSchedule(push, self.physics)
        num_free = self._num_free_steps(schedule) if is_simulated else schedule.num_steps
        for i in range(1, num_free + 1):
            yield PushFrame(self._poses, (*schedule.position(i), push.yaw))
        if not is_simulated:
            return PushOutcome(num_steps=num_free)
        steps = self._simulate(push, is_touching)
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

    def _meets(self, footprint: Polygon, depth: float) -> bool:
        (x0, y0), _, (x1, y1), _ = footprint.tolist()
        x, y, reach = (x0 + x1) / 2, (y0 + y1) / 2, math.hypot(x1 - x0, y1 - y0) / 2
        for pose in self._poses:
            gap = math.hypot(pose.position[0] - x, pose.position[1] - y)
            # No part of a cube is further from its centre than 0.87 of its side.
            if is_fallen(pose) or gap > reach + 0.87 * pose.side - depth:
                continue
            if penetration(footprint, block_footprint(pose)) > depth:
                return True
        return False

    def _simulate(self, push: Push, is_touching: bool) -> Generator[None, None, PushOutcome]:
        schedule = PusherSchedule(push, self.physics)
        self._world.build(self._poses)
        try:
            yield from self._move_pusher(schedule)
            self._world.take_away_fallen()
            num_settle_steps, is_settled = yield from settle(self._world)
            after = self._world.checked_poses()
        except SimulationError:
            self._world.discard()
            raise
        before, self._poses = self._poses, after
        return PushOutcome(
            is_touching=is_touching,
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

    def _move_pusher(self, schedule: PusherSchedule) -> Generator[None, None, None]:
        world, push = self._world, schedule.push
        first = self._num_free_steps(schedule)
        world.place_pusher(*schedule.position(first), push.yaw)
        for i in range(first + 1, schedule.num_push_steps + 1):
            world.drive_pusher(*schedule.position(i))
            yield
        error = math.dist(world.pusher_pose()[:2], push.end)
        if not error < MAX_PUSHER_ERROR:
            raise SimulationError(
                f"the pusher stopped {error:.3g} m off its path; the scene is as before the push"
            )
        is_free, next_look = False, schedule.num_push_steps + 1
        for i in range(schedule.num_push_steps + 1, schedule.num_steps + 1):
            if not (is_free or self.exact) and i >= next_look:
                world.take_away_fallen()
                speeds = world.top_speeds()
                check_speeds(speeds, self.physics.max_speed)
                is_free = self._is_left_alone(speeds)
                next_look = i + num_moving_steps(speeds, self.physics)
            if is_free:
                world.place_pusher(*schedule.position(i), push.yaw)
            else:
                world.drive_pusher(*schedule.position(i))
            yield
        world.park_pusher()

    def _num_free_steps(self, schedule: PusherSchedule) -> int:
        return 0 if self.exact else schedule.num_free_steps(self._poses)

    def _is_left_alone(self, speeds: TopSpeeds) -> bool:
        """Whether the blocks lie still and nothing that the pusher does will move them."""
        return is_still(speeds, self.physics.settle_speed) and not self._world.is_pusher_touching()
