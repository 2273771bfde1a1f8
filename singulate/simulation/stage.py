"""What the cameras see: boxes without physics, kept and moved from scene to scene."""

from singulate.geometry import Poses, Workspace
from singulate.simulation.bodies import TABLE_THICKNESS, UPRIGHT, add_visible_box
from singulate.simulation.bullet import pybullet
from singulate.simulation.fallen import is_fallen
from singulate.simulation.palette import BLOCK_COLOURS, TABLE_COLOUR

_OUT_OF_SIGHT = (0.0, 0.0, 100.0)
_MAX_REPLACED = 500
"""Bullet frees what belonged to a replaced block (4 KB) only when the whole stage is cleared."""


class Stage:
    """Owns the Bullet connection that pictures are taken of.

    Taking a picture must not disturb the physics, and most pushes touch nothing and need no
    physics at all, so pictures have a world of their own. Its blocks are a pool: block i is moved
    to where it stands in the next scene, and replaced only where its side changes.

    Args:
        workspace: The square that the table covers.
        has_table: Whether the table is seen.
    """

    def __init__(self, workspace: Workspace, has_table: bool = True) -> None:
        self.client = pybullet.connect(pybullet.DIRECT)
        self._half_length = workspace.half_length
        self._has_table = has_table
        self._pool: list[tuple[int, float]] = []
        """Body and side of each block, in the order of the blocks."""
        self._num_replaced = 0
        self._clear()

    def close(self) -> None:
        """Disconnect from Bullet; further calls do nothing."""
        if self.client >= 0:
            pybullet.disconnect(physicsClientId=self.client)
            self.client = -1

    def show(self, poses: Poses) -> None:
        """Put the blocks where they stand; those that have fallen off are out of sight."""
        if self._num_replaced > _MAX_REPLACED:
            self._clear()
        for i, pose in enumerate(poses):
            position = _OUT_OF_SIGHT if is_fallen(pose) else pose.position
            pybullet.resetBasePositionAndOrientation(
                self._block(i, pose.side), position, pose.quaternion, physicsClientId=self.client
            )
        for body, _ in self._pool[len(poses) :]:
            pybullet.resetBasePositionAndOrientation(
                body, _OUT_OF_SIGHT, UPRIGHT, physicsClientId=self.client
            )

    def _block(self, index: int, side: float) -> int:
        if index < len(self._pool):
            body, pooled_side = self._pool[index]
            if pooled_side == side:
                return body
            pybullet.removeBody(body, physicsClientId=self.client)
            self._num_replaced += 1
        colour = BLOCK_COLOURS[index % len(BLOCK_COLOURS)]
        body = add_visible_box(self.client, (side / 2,) * 3, _OUT_OF_SIGHT, UPRIGHT, colour)
        self._pool[index : index + 1] = [(body, side)]
        return body

    def _clear(self) -> None:
        pybullet.resetSimulation(physicsClientId=self.client)
        self._pool.clear()
        self._num_replaced = 0
        if self._has_table:
            self._add_table()

    def _add_table(self) -> None:
        half = self._half_length
        add_visible_box(
            self.client,
            (half, half, TABLE_THICKNESS / 2),
            (0.0, 0.0, -TABLE_THICKNESS / 2),
            UPRIGHT,
            TABLE_COLOUR,
        )
