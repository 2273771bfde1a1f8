"""The live table: blocks at rest, pushes, and the camera above."""

import math
from collections.abc import Generator
from dataclasses import dataclass
from types import TracebackType
from typing import NamedTuple, Self

import numpy as np
import numpy.typing as npt

from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import CameraFrame, Layout, Poses, Push, Workspace, standing_pose
from singulate.geometry.rectangle import penetration
from singulate.simulation.camera import OverheadCamera, picture
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import (
    SWEEP_MARGIN,
    block_footprint,
    pusher_footprint,
    swept_footprint,
)
from singulate.simulation.physics import Physics
from singulate.simulation.stage import Stage
from singulate.simulation.world import World

_MAX_PUSHER_ERROR = 0.02
"""A pusher further than this from its target means that the physics went wrong [m]."""


@dataclass(frozen=True)
class PushOutcome:
    """What happened on the table.

    Attributes:
        is_blocked: The pusher would have been lowered onto a block; nothing was simulated.
        is_touching: The strip that the pusher sweeps meets a block; otherwise nothing moves.
        is_settled: Everything was still at the end.
        fallen: Indices of the blocks that this push sent off the table.
        moved: Largest displacement of a block [m].
        num_steps: Simulation steps that were run.
    """

    is_blocked: bool = False
    is_touching: bool = False
    is_settled: bool = True
    fallen: tuple[int, ...] = ()
    moved: float = 0.0
    num_steps: int = 0


class PushFrame(NamedTuple):
    """One moment of a push: block poses, and the pusher's (x, y, z) [m] and yaw [rad]."""

    poses: Poses
    pusher: tuple[float, float, float, float]


class Scene:
    """A table with blocks, one pusher and one camera.

    The outcome of a push is a pure function of the blocks' poses and the push: the same bits
    whatever happened before, in whichever process.

    Args:
        workspace: The square that the table covers.
        physics: Physical constants.
    """

    def __init__(self, workspace: Workspace | None = None, physics: Physics | None = None) -> None:
        self.workspace = workspace or Workspace()
        self.physics = physics or Physics()
        self._world = World(self.workspace, self.physics)
        self._stage = Stage(self.workspace)
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
        steps = self._simulate(push)
        while True:
            try:
                next(steps)
            except StopIteration as stop:
                outcome: PushOutcome = stop.value
                return outcome

    def push_steps(self, push: Push) -> Generator[PushFrame, None, PushOutcome]:
        """Execute a push step by step, for watching; the result is the same as `push`.

        Yields:
            The live poses after each simulation step. A push that touches nothing is simulated
            too, so that it can be watched; a blocked one yields nothing.

        Raises:
            SimulationError: As `push`.
        """
        steps = self._simulate(push, is_watched=True)
        while True:
            try:
                next(steps)
            except StopIteration as stop:
                outcome: PushOutcome = stop.value
                return outcome
            yield PushFrame(self._world.block_poses(), self._world.pusher_pose())

    def photograph(self) -> CameraFrame:
        """What the camera sees of the blocks at rest."""
        self._stage.show(self._poses)
        return self._camera.photograph(self._stage.client)

    def picture(self, width: int = 480, height: int = 360) -> npt.NDArray[np.uint8]:
        """A view of the table for people, uint8 (height, width, 3)."""
        self._stage.show(self._poses)
        return picture(self._stage.client, width, height, self.workspace.half_length)

    def _meets(self, footprint: npt.NDArray[np.float64], depth: float) -> bool:
        centre = footprint.mean(axis=0)
        reach = np.linalg.norm(footprint - centre, axis=1).max()
        for pose in self._poses:
            gap = math.hypot(pose.position[0] - centre[0], pose.position[1] - centre[1])
            # No part of a cube is further from its centre than 0.87 of its side.
            if is_fallen(pose) or gap > reach + 0.87 * pose.side - depth:
                continue
            if penetration(footprint, block_footprint(pose)) > depth:
                return True
        return False

    def _simulate(self, push: Push, is_watched: bool = False) -> Generator[None, None, PushOutcome]:
        if self.is_blocked(push):
            return PushOutcome(is_blocked=True)
        is_touching = self.touches(push)
        if not (is_touching or is_watched):
            return PushOutcome()
        self._world.build(self._poses)
        num_push_steps = yield from self._move_pusher(push)
        num_settle_steps, is_settled = yield from self._settle(push)
        if not is_touching:
            return PushOutcome(num_steps=num_push_steps + num_settle_steps)
        before, self._poses = self._poses, self._checked_poses()
        return PushOutcome(
            is_touching=True,
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
            num_steps=num_push_steps + num_settle_steps,
        )

    def _move_pusher(self, push: Push) -> Generator[None, None, int]:
        world, physics = self._world, self.physics
        num_steps = max(1, round(push.length / (physics.push_speed * physics.time_step)))
        (x, y), (dx, dy) = push.start, push.direction
        world.place_pusher(x, y, push.yaw)
        for i in range(1, num_steps + 1):
            along = push.length * i / num_steps
            world.drive_pusher(x + along * dx, y + along * dy, physics.pusher_z)
            yield
        error = math.dist(world.pusher_pose()[:2], push.end)
        if not error < _MAX_PUSHER_ERROR:
            raise SimulationError(
                f"the pusher stopped {error:.3g} m off its path; the scene is as before the push"
            )
        return num_steps

    def _settle(self, push: Push) -> Generator[None, None, tuple[int, bool]]:
        world, physics = self._world, self.physics
        num_lift_steps = math.ceil(
            physics.retract_height / (physics.retract_speed * physics.time_step)
        )
        x, y = push.end
        for i in range(1, num_lift_steps + 1):
            world.drive_pusher(x, y, physics.pusher_z + physics.retract_height * i / num_lift_steps)
            yield
        world.park_pusher()
        for i in range(physics.max_settle_steps):
            self._check_speeds()
            world.remove_fallen()
            if self._is_still():
                return num_lift_steps + i, True
            world.step()
            yield
        world.remove_fallen()
        return num_lift_steps + physics.max_settle_steps, False

    def _is_still(self) -> bool:
        limit = self.physics.settle_speed
        return all(
            linear < limit and angular < 10 * limit
            for linear, angular in self._world.block_speeds()
        )

    def _check_speeds(self) -> None:
        for linear, angular in self._world.block_speeds():
            if not (linear < self.physics.max_speed and math.isfinite(angular)):
                raise SimulationError(
                    f"a block reached {linear:.3g} m/s; the scene is as before the push"
                )

    def _checked_poses(self) -> Poses:
        poses = self._world.block_poses()
        if not all(math.isfinite(v) for pose in poses for v in (*pose.position, *pose.quaternion)):
            raise SimulationError("a block's pose is not finite; the scene is as before the push")
        return poses
