"""Hands on the blocks: drags that hold them, and what becomes of the blocks' poses."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from app.commands import AddBlock, ArrangeBlocks, HoldBlock, MoveBlock, ReleaseBlock, RemoveBlock
from app.processes.free_place import free_place, nearest_free
from singulate.exceptions import InvalidValueError
from singulate.finite import is_finite_number
from singulate.geometry import Block, BlockPose, Poses, Workspace, standing_pose
from singulate.geometry.rectangle import Polygon
from singulate.simulation.fallen import is_fallen
from singulate.simulation.footprint import block_footprint

MAX_BLOCKS = 10
ADDED_SIDE = 0.2
"""Side of an added block, as in the scenario ``fixed`` [m]."""
_STILL = 1e-6
"""A shorter way is none [m]."""
_ROOM = 0.12
"""Gap around an added block: enough to count as singulated [m]."""


@dataclass(frozen=True)
class Arrangement:
    """New places of the blocks.

    Attributes:
        poses: Where all blocks stand now.
        is_new_step: Whether undo returns to the state before.
    """

    poses: Poses
    is_new_step: bool


@dataclass
class Hold:
    """A block in somebody's hand."""

    index: int
    by: str
    has_moved: bool = False


class Hands:
    """All drags that are under way; the last command about a block decides.

    Args:
        workspace: The blocks stay inside.
    """

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self._holds: dict[int, Hold] = {}

    @property
    def newest(self) -> Hold | None:
        """What was taken hold of last, of all that is still held."""
        return next(reversed(self._holds.values()), None)

    def let_go(self) -> None:
        """End all drags: the blocks have moved otherwise."""
        self._holds.clear()

    def arrange(self, command: ArrangeBlocks, poses: Poses) -> Arrangement | None:
        """Carry a command out.

        Args:
            command: What somebody does with a block.
            poses: All blocks at rest.

        Returns:
            None where no block moves.

        Raises:
            InvalidValueError: If a value is not allowed, or there is no room.
        """
        match command:
            case HoldBlock(drag, index, by):
                hold = Hold(_standing(index, poses), str(by))
                self._holds.pop(drag, None)
                self._holds[drag] = hold
            case MoveBlock(drag):
                return self._move(command, self._holds.get(drag), poses)
            case ReleaseBlock(drag):
                self._holds.pop(drag, None)
            case AddBlock():
                return Arrangement((*poses, self._added(poses)), is_new_step=True)
            case RemoveBlock(index):
                return self._without(_standing(index, poses), poses)
            case _:
                return self._turned(_standing(command.index, poses), command.angle, poses)
        return None

    def _move(self, command: MoveBlock, hold: Hold | None, poses: Poses) -> Arrangement | None:
        place = None if command.place is None else _checked_place(command.place, self._workspace)
        yaw = None if command.yaw is None else _finite("yaw", command.yaw)
        moved = None if hold is None else self._placed(hold.index, place, yaw, poses)
        if hold is None or moved is None:
            return None
        is_first, hold.has_moved = not hold.has_moved, True
        return Arrangement(moved, is_new_step=is_first)

    def _turned(self, index: int, angle: object, poses: Poses) -> Arrangement | None:
        yaw = standing_block(poses[index]).yaw + _finite("angle", angle)
        turned = self._placed(index, None, yaw, poses)
        return None if turned is None else Arrangement(turned, is_new_step=True)

    def _placed(
        self, index: int, place: tuple[float, float] | None, yaw: float | None, poses: Poses
    ) -> Poses | None:
        start = standing_block(poses[index])
        x, y = place or (start.x, start.y)
        # A cube looks the same after a quarter turn, so it never turns further than half of that.
        turn = 0.0 if yaw is None else math.remainder(yaw - start.yaw, math.pi / 2)
        if math.hypot(x - start.x, y - start.y) < _STILL and turn == 0.0:
            return None
        wanted = Block(x, y, start.side, start.yaw + turn)
        others = _footprints(pose for i, pose in enumerate(poses) if i != index)
        pose = standing_pose(nearest_free(wanted, start, others, self._workspace))
        return (*poses[:index], pose, *poses[index + 1 :])

    def _added(self, poses: Poses) -> BlockPose:
        if len(poses) >= MAX_BLOCKS:
            raise InvalidValueError("blocks", f"{len(poses) + 1} blocks", f"1 to {MAX_BLOCKS}")
        block = free_place(ADDED_SIDE, _footprints(poses), self._workspace, _ROOM)
        block = block or free_place(ADDED_SIDE, _footprints(poses), self._workspace, 0.0)
        if block is None:
            raise InvalidValueError("blocks", "another block", "room for it: move the others")
        return standing_pose(block)

    def _without(self, index: int, poses: Poses) -> Arrangement:
        if len(poses) == 1:
            raise InvalidValueError("blocks", "0 blocks", f"1 to {MAX_BLOCKS}")
        self.let_go()  # the blocks after it have other numbers now
        return Arrangement((*poses[:index], *poses[index + 1 :]), is_new_step=True)


def standing_block(pose: BlockPose) -> Block:
    """The block as it would stand at its place; one that leans is put upright."""
    x, y, _ = pose.position
    if pose.quaternion[:2] == (0.0, 0.0):
        return Block(x, y, pose.side, pose.yaw)
    outline = block_footprint(pose)
    edges = (np.roll(outline, -1, axis=0) - outline).tolist()
    dx, dy = max(edges, key=lambda edge: math.hypot(*edge))
    return Block(x, y, pose.side, math.atan2(dy, dx))


def _footprints(poses: Iterable[BlockPose]) -> list[Polygon]:
    return [block_footprint(pose) for pose in poses if not is_fallen(pose)]


def _standing(index: object, poses: Poses) -> int:
    if isinstance(index, bool) or not isinstance(index, int) or not 0 <= index < len(poses):
        raise InvalidValueError("block", index, f"a whole number from 0 to {len(poses) - 1}")
    if is_fallen(poses[index]):
        raise InvalidValueError("block", index, "a block that is on the table")
    return index


def _checked_place(place: object, workspace: Workspace) -> tuple[float, float]:
    allowed = f"(x, y) within {workspace.half_length} m of the centre lines"
    if not isinstance(place, tuple) or len(place) != 2:
        raise InvalidValueError("place", place, allowed)
    x, y = (_finite("place", value) for value in place)
    if not workspace.contains(x, y):
        raise InvalidValueError("place", place, allowed)
    return x, y


def _finite(key: str, value: object) -> float:
    if not is_finite_number(value):
        raise InvalidValueError(key, value, "a finite number")
    return float(value)
