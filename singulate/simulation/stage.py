"""The table as people see it: boxes without physics, kept and moved from scene to scene."""

from singulate.geometry import Poses, Workspace
from singulate.simulation.boxes import (
    OUT_OF_SIGHT,
    TABLE_THICKNESS,
    UPRIGHT,
    add_visible_boxes,
    move_body,
)
from singulate.simulation.bullet import pybullet
from singulate.simulation.fallen import is_fallen
from singulate.simulation.palette import TABLE_COLOUR, block_colour
from singulate.simulation.resting import resting_place, solid_half_extents

_MAX_REPLACED = 500
"""Bullet frees what belonged to a replaced block (4 KB) only when the whole stage is cleared."""


class Stage:
    """Owns the Bullet connection that pictures with the table are taken of.

    Its blocks are a pool: block i is moved to where it stands in the next scene. They are replaced
    where a block has another side than before.

    Args:
        workspace: The square that the table covers.
    """

    def __init__(self, workspace: Workspace) -> None:
        self.client = pybullet.connect(pybullet.DIRECT)
        self._half_length = workspace.half_length
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
        self._fit_pool(poses)
        for (body, _), pose in zip(self._pool, poses, strict=False):
            place = (OUT_OF_SIGHT, UPRIGHT) if is_fallen(pose) else resting_place(pose)
            move_body(self.client, body, *place)
        for body, _ in self._pool[len(poses) :]:
            move_body(self.client, body, OUT_OF_SIGHT, UPRIGHT)

    def _fit_pool(self, poses: Poses) -> None:
        """Give every block a body of its side; where one has none, all are made anew."""
        sides = [pose.side for pose in poses]
        if [side for _, side in self._pool[: len(sides)]] == sides:
            return
        for body in sorted((body for body, _ in self._pool), reverse=True):
            pybullet.removeBody(body, physicsClientId=self.client)
        self._num_replaced += len(self._pool)
        bodies: dict[int, int] = {}
        for side in dict.fromkeys(sides):
            indices = [i for i, each in enumerate(sides) if each == side]
            colours = [block_colour(i) for i in indices]
            made = add_visible_boxes(self.client, solid_half_extents(side), colours)
            bodies.update(zip(indices, made, strict=True))
        self._pool = [(bodies[i], side) for i, side in enumerate(sides)]

    def _clear(self) -> None:
        pybullet.resetSimulation(physicsClientId=self.client)
        self._pool.clear()
        self._num_replaced = 0
        self._add_table()

    def _add_table(self) -> None:
        half = self._half_length
        half_extents = (half, half, TABLE_THICKNESS / 2)
        (table,) = add_visible_boxes(self.client, half_extents, [TABLE_COLOUR])
        move_body(self.client, table, (0.0, 0.0, -TABLE_THICKNESS / 2), UPRIGHT)
