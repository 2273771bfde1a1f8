"""Pushes from many starts on one line, simulated together.

Until it touches something, a pusher leaves no trace. So pushes along one line that meet the same
block first share one trajectory: it begins just before the contact and goes on at constant speed,
and where one of the pushes ends, a copy of the blocks is let come to rest in a second world.
"""

import math
from collections import deque
from collections.abc import Iterator, Sequence
from types import TracebackType
from typing import NamedTuple, Self

from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import CameraFrame, Poses, Push, Workspace
from singulate.simulation.approach import SWEEP_MARGIN, block_intervals
from singulate.simulation.camera import OverheadCamera
from singulate.simulation.motion import Motion, fastest, is_same
from singulate.simulation.physics import Physics
from singulate.simulation.pixel_window import PixelWindow, window_of
from singulate.simulation.push_simulation import LEAD_STEPS, MAX_PUSHER_ERROR
from singulate.simulation.settling import settle
from singulate.simulation.world import World

_ANY_PIXEL = PixelWindow(0, 1, 0, 1)
_RUB_MARGIN = 1e-4
"""A pusher that comes down beside a block at more than this does not touch it there [m]."""


class LineEnd(NamedTuple):
    """How one of the pushes ended.

    Attributes:
        push_index: Which push.
        poses: The blocks at rest; the same object as of the end before where nothing has changed.
            None where the physics went wrong.
    """

    push_index: int
    poses: Poses | None


class _Start(NamedTuple):
    """One push of a trajectory: which, and where along the line it begins [m]."""

    push_index: int
    offset: float


class SharedTrajectories:
    """Simulates pushes along lines of one scene after another.

    Bullet does not return to a saved moment to the last bit, so an end depends, in its last digits,
    on what was asked since `place`; the same questions always have the same answers.

    Args:
        workspace: The square that the table covers.
        physics: Physical constants.
    """

    def __init__(self, workspace: Workspace, physics: Physics) -> None:
        self._physics = physics
        self._pushing = World(workspace, physics)
        self._settling = World(workspace, physics)
        self._camera = OverheadCamera(workspace)
        self._workspace = workspace
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
        self._pushing.close()
        self._settling.close()

    def place(self, poses: Poses) -> None:
        """Put up the blocks at rest to which all pushes from now on are done."""
        self._poses = poses
        self._settling.build(poses)
        self._put_up()

    def ends(self, pushes: Sequence[Push]) -> Iterator[LineEnd]:
        """Execute pushes that lie on one line.

        Args:
            pushes: Of one direction and one length, none of them blocked, at least one.

        Yields:
            The end of each push, in no particular order.

        Raises:
            InvalidValueError: If the pushes do not lie on one line.
        """
        line = pushes[0]
        starts = [_Start(i, _offset(line, push)) for i, push in enumerate(pushes)]
        for contact, group in self._groups(line, starts):
            yield from self._follow(line, contact, group)

    def photograph(self, poses: Poses) -> CameraFrame:
        """The part of the camera's picture of an end in which all blocks are."""
        self._settling.show(poses)
        window = window_of(poses, self._workspace) or _ANY_PIXEL
        return self._camera.photograph_part(self._settling.client, window)

    def _put_up(self) -> None:
        """Build the world of the pusher and let the blocks settle, as before any push."""
        self._pushing.build(self._poses)
        self._pushing.rest(LEAD_STEPS)
        self._pushing.save()

    def _groups(self, line: Push, starts: Sequence[_Start]) -> list[tuple[float, list[_Start]]]:
        """Starts by the trajectory that they share, with the point where it may begin [m]."""
        half = self._physics.pusher_side / 2
        reached, rubbed = (
            block_intervals(self._poses, line.start, line.direction, half + margin)
            for margin in (SWEEP_MARGIN, _RUB_MARGIN)
        )
        groups: dict[tuple[float, int], list[_Start]] = {}
        for start in sorted(starts, key=lambda start: start.offset):
            ahead = [first for first, last in reached if last + half > start.offset]
            nearest = min(ahead, default=math.inf) - half
            # A pusher that is lowered right beside a block has a trajectory of its own.
            is_beside = any(first - half < start.offset < last + half for first, last in rubbed)
            key = (start.offset, start.push_index) if is_beside else (nearest, -1)
            groups.setdefault(key, []).append(start)
        return [(contact, group) for (contact, _), group in groups.items()]

    def _follow(self, line: Push, contact: float, group: list[_Start]) -> Iterator[LineEnd]:
        if contact > group[-1].offset + line.length:
            yield from (LineEnd(start.push_index, self._poses) for start in group)
            return
        if not self._pushing.go_back():
            self._put_up()
        at = self._last_step_before(min(contact, group[0].offset + line.length), group[-1].offset)
        self._pushing.place_pusher(*_point(line, at), self._physics.pusher_z, line.yaw)
        motions: list[Motion] = []
        try:
            for start in group:
                end = start.offset + line.length
                self._drive(line, at, end)
                motions.append(self._pushing.motion())
                at = end
        except SimulationError:
            self._pushing.discard()
        yield from (LineEnd(lost.push_index, None) for lost in group[len(motions) :])
        rest: Poses | None = None
        settled: Motion | None = None
        for start, motion in zip(group, motions, strict=False):
            if settled is None or not is_same(motion, settled):
                rest, settled = self._come_to_rest(motion), motion
            yield LineEnd(start.push_index, rest)

    def _last_step_before(self, limit: float, start: float) -> float:
        """The last point that a pusher passes in whole steps from a start up to a limit [m]."""
        step = self._physics.push_speed * self._physics.time_step
        return start + math.floor((limit - start) / step + 1e-9) * step

    def _drive(self, line: Push, begin: float, end: float) -> None:
        """Move the pusher along the line in whole time steps at its speed, or a little slower."""
        world, physics = self._pushing, self._physics
        num_steps = math.ceil((end - begin) / (physics.push_speed * physics.time_step) - 1e-9)
        (x, y), (dx, dy), z = line.start, line.direction, physics.pusher_z
        points = [begin + (end - begin) * i / num_steps for i in range(1, num_steps + 1)]
        path = [(x + at * dx, y + at * dy, z) for at in points]
        deque(world.drive_pusher(path), maxlen=0)
        if num_steps and not math.dist(world.pusher_pose()[:2], _point(line, end)) < (
            MAX_PUSHER_ERROR
        ):
            raise SimulationError("the pusher left its path")

    def _come_to_rest(self, motion: Motion) -> Poses | None:
        """Poses of blocks that moved like that, once they are still; None if that went wrong."""
        try:
            self._settling.set_motion(motion)
            self._settling.loosen()
            speeds = fastest((block.velocity, block.spin) for block in motion)
            deque(settle(self._settling, speeds, is_watched=False), maxlen=0)
            return self._settling.checked_poses()
        except SimulationError:
            self._settling.discard()
            return None


def _offset(line: Push, push: Push) -> float:
    """Where along a line a push begins [m]."""
    dx, dy = push.start[0] - line.start[0], push.start[1] - line.start[1]
    ux, uy = line.direction
    is_same = push.direction == line.direction and push.length == line.length
    if not is_same or abs(dy * ux - dx * uy) > 1e-9:
        raise InvalidValueError("push", push, f"on the line of {line}")
    return dx * ux + dy * uy


def _point(line: Push, offset: float) -> tuple[float, float]:
    return (
        line.start[0] + offset * line.direction[0],
        line.start[1] + offset * line.direction[1],
    )
