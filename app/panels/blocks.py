"""Buttons that add, turn and remove a block."""

import math

from app.commands import AddBlock, RemoveBlock, TurnBlock
from app.panels.context import PanelContext
from app.panels.listening import on_pick
from app.snapshot import SceneSnapshot

TURN = math.radians(15.0)
HINT = "Drag a block to move it, with Shift to turn it; these buttons take the one moved last"


class BlocksPanel:
    """Changes the blocks on the table; part of the tab *Interact*.

    Attributes:
        chosen: The block that this person moved last, if any.
    """

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self._scene: SceneSnapshot | None = None
        self.chosen: int | None = None
        self.buttons = context.gui.add_button_group("Blocks", ("Add", "Turn", "Remove"), hint=HINT)
        on_pick(self.buttons, self.press)

    def update(self, scene: SceneSnapshot | None) -> None:
        """Know the table."""
        self._scene = scene

    def press(self, button: int) -> None:
        """Carry out button 0 (add), 1 (turn) or 2 (remove)."""
        if button == 0:
            self._context.submit(AddBlock())
            return
        index = self._block()
        if index is None:
            return
        if button == 1:
            self._context.submit(TurnBlock(index, TURN))
        else:
            self.chosen = None
            self._context.submit(RemoveBlock(index))

    def _block(self) -> int | None:
        """The chosen block, or the last one that is on the table."""
        poses = () if self._scene is None else self._scene.poses
        standing = [index for index, pose in enumerate(poses) if pose.position[2] > 0.0]
        if self.chosen in standing:
            return self.chosen
        return standing[-1] if standing else None
