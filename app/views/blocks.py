"""The blocks and their shadows, moved in place."""

from collections.abc import Callable

import viser

from app.views.palette import BLOCK_COLOURS
from app.views.shadows import ShadowsView
from singulate.geometry import BlockPose, Poses

_LOWEST = 0.0
"""A block whose centre is below the table [m] has fallen off and is not drawn."""

OnDrag = Callable[[int, viser.SceneNodeDragEvent[viser.BoxHandle]], None]
"""Called with the number of a block and what a browser's pointer does to it."""


class BlocksView:
    """All blocks, the same in every browser; handles are made once and then only moved.

    Args:
        scene: The scene that all browsers share.
        on_drag: Told of drags with the left button, with and without Shift.
    """

    def __init__(self, scene: viser.SceneApi, on_drag: OnDrag) -> None:
        self._scene = scene
        self._on_drag = on_drag
        self._boxes: list[viser.BoxHandle] = []
        self._shadows = ShadowsView(scene)
        self._shown: Poses = ()

    def update(self, poses: Poses) -> None:
        """Show these blocks and no others."""
        standing = tuple(pose if pose.position[2] > _LOWEST else None for pose in poses)
        if poses == self._shown:
            return
        self._shown = poses
        for index in range(len(self._boxes), len(poses)):
            self._boxes.append(self._add(index))
        for index, box in enumerate(self._boxes):
            _place(box, standing[index] if index < len(standing) else None)
        self._shadows.update(tuple(pose for pose in standing if pose is not None))

    def _add(self, index: int) -> viser.BoxHandle:
        colour = BLOCK_COLOURS[index % len(BLOCK_COLOURS)]
        box = self._scene.add_box(f"/blocks/{index}", colour, visible=False, cast_shadow=False)

        # A coroutine that never waits: viser keeps the order of its calls.
        async def on_drag(event: viser.SceneNodeDragEvent[viser.BoxHandle]) -> None:
            self._on_drag(index, event)

        box.on_drag("left")(on_drag)
        box.on_drag("left", modifier="shift")(on_drag)
        return box


def _place(box: viser.BoxHandle, pose: BlockPose | None) -> None:
    if pose is not None:
        x, y, z, w = pose.quaternion
        if tuple(box.position) != pose.position:
            box.position = pose.position
        box.wxyz = (w, x, y, z)
        if box.dimensions[0] != pose.side:
            box.dimensions = (pose.side, pose.side, pose.side)
    if box.visible != (pose is not None):
        box.visible = pose is not None
