"""From the mouse to a block: drags that move it, and with Shift turn it."""

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from math import pi

import viser

from app.commands import Command, HoldBlock, MoveBlock, ReleaseBlock
from app.pointer import Point, Point3, seen_at
from singulate.geometry import BlockPose, Workspace

TURN_PER_PICTURE = 2 * pi
"""How far a block turns while the pointer crosses the whole picture from left to right [rad]."""

_numbers = itertools.count(1)
"""Of all browsers' drags, so that the scene can tell them apart."""


@dataclass(frozen=True)
class Grip:
    """Where a block was when it was grabbed, and where it was grabbed.

    Attributes:
        drag: Number of the drag.
        centre: Of the block (x, y) [m].
        yaw: Of the block [rad].
        point: That was grabbed on it (x, y, z) [m].
        picture_x: Place of the pointer in the picture, 0 (left) to 1 (right).
    """

    drag: int
    centre: Point
    yaw: float
    point: Point3
    picture_x: float

    def moved_to(self, pointer: Point, workspace: Workspace) -> MoveBlock:
        """Bring the grabbed point under the pointer, as far as the table reaches."""
        reach = workspace.half_length
        x, y = (
            min(max(centre + now - before, -reach), reach)
            for centre, now, before in zip(self.centre, pointer, self.point, strict=False)
        )
        return MoveBlock(self.drag, place=(x, y))

    def turned_to(self, picture_x: float) -> MoveBlock:
        """Turn by how far the pointer has gone sideways: the block's front follows it."""
        return MoveBlock(self.drag, yaw=self.yaw + TURN_PER_PICTURE * (picture_x - self.picture_x))


class BlockPointer:
    """One browser's drags of blocks, turned into commands.

    Args:
        client: The browser.
        workspace: Blocks are moved inside it.
        name: What the others call this person.
        submit: Takes commands to the laboratory.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        workspace: Workspace,
        name: str,
        submit: Callable[[Command], None],
    ) -> None:
        self._client = client
        self._workspace = workspace
        self._name = name
        self._submit = submit
        self._grip: Grip | None = None

    def drag(
        self, index: int, pose: BlockPose, event: viser.SceneNodeDragEvent[viser.BoxHandle]
    ) -> None:
        """Follow a drag; phases have to come in order.

        Args:
            index: The block.
            pose: Where it is.
            event: What the pointer does; with a modifier the block is turned.
        """
        if event.phase == "start":
            self._grab(index, pose, event)
            return
        grip = self._grip
        if grip is None:
            return
        if event.modifier is not None:
            self._submit(grip.turned_to(event.end_screen_pos[0]))
        else:
            pointer = seen_at(self._client, event.end_position, height=grip.point[2])
            if pointer is not None:
                self._submit(grip.moved_to(pointer, self._workspace))
        if event.phase == "end":
            self.release()

    def release(self) -> None:
        """Let go of what is held."""
        if self._grip is not None:
            self._submit(ReleaseBlock(self._grip.drag))
            self._grip = None

    def _grab(
        self, index: int, pose: BlockPose, event: viser.SceneNodeDragEvent[viser.BoxHandle]
    ) -> None:
        self.release()
        self._grip = Grip(
            drag=next(_numbers),
            centre=pose.position[:2],
            yaw=pose.yaw,
            point=event.start_position,
            picture_x=event.start_screen_pos[0],
        )
        self._submit(HoldBlock(self._grip.drag, index, self._name))
