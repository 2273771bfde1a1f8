"""Arrows on the table: the push that is aimed at, and the last one's ghost.

They are meshes of their own, because a browser makes two kinds of surface for viser's arrows, each
of which a computer without a GPU compiles for a quarter of a second when a page opens; these are
shaded like blocks.
"""

import math

import viser

from app.aim import Aim
from app.page_script import run_script
from app.views.arrow_mesh import ArrowShape
from app.views.palette import AIM_COLOUR, Colour, surface
from singulate.geometry import Push, Workspace

_AIM_HEIGHT = 0.012
_GHOST_HEIGHT = 0.008
_AIM_NODE = "/aim"
_OUT_OF_SIGHT = (0.0, 0.0, -5.0)
"""Where an arrow waits until it is placed: behind the table, from wherever the table is seen."""


class ArrowView:
    """One flat arrow that is moved, turned and hidden in place.

    Args:
        scene: Where it is drawn.
        name: Its node.
        colour: Its colour.
        thickness: Half the width of its shaft [m].
        height: How far above the table it lies [m].
        length: From tail to tip [m].
    """

    def __init__(
        self,
        scene: viser.SceneApi,
        name: str,
        colour: Colour,
        *,
        thickness: float,
        height: float,
        length: float,
    ) -> None:
        self._height = height
        self._shape = ArrowShape(thickness)
        self._length = length
        self._start: tuple[float, float] | None = None
        self._yaw = 0.0
        self._arrow = scene.add_mesh_simple(
            name,
            self._shape.vertices(length),
            self._shape.faces(),
            color=colour,
            flat_shading=True,
            cast_shadow=False,
            position=_OUT_OF_SIGHT,
            visible=False,
        )

    def paint(self, colour: Colour) -> None:
        """Change its colour."""
        self._arrow.color = colour

    def place(self, start: tuple[float, float]) -> None:
        """Put its tail at a place (x, y) [m]."""
        if start != self._start:
            self._start = start
            self._arrow.position = (*start, self._height)

    def turn(self, direction: tuple[float, float]) -> None:
        """Point along a unit vector (x, y)."""
        yaw = math.atan2(direction[1], direction[0])
        if yaw != self._yaw:
            self._yaw = yaw
            self._arrow.wxyz = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))

    def stretch(self, length: float) -> None:
        """Reach this far [m]."""
        if length != self._length:
            self._length = length
            self._arrow.vertices = self._shape.vertices(length)

    def show(self, is_visible: bool) -> None:
        """Show or hide it."""
        if self._arrow.visible != is_visible:
            self._arrow.visible = is_visible


class AimView:
    """The arrow of the push that one person aims at; it follows their pointer.

    Args:
        client: The browser.
        workspace: Where it follows the pointer, and how far a push goes.
    """

    def __init__(self, client: viser.ClientHandle, workspace: Workspace) -> None:
        self._arrow = ArrowView(
            client.scene,
            _AIM_NODE,
            AIM_COLOUR,
            thickness=0.012,
            height=_AIM_HEIGHT,
            length=workspace.push_length,
        )
        run_script(
            client,
            "hover.js",
            node=_AIM_NODE,
            reach=f"{workspace.half_length:.6f}",
            height=f"{_AIM_HEIGHT:.6f}",
        )

    def update(self, aim: Aim, is_shown: bool) -> None:
        """Point in the aimed direction, from the aimed start until the pointer moves on."""
        if aim.start is not None:
            self._arrow.place(aim.start)
        self._arrow.turn(aim.direction.vector)
        self._arrow.show(is_shown)


class GhostView:
    """The arrow that the last push leaves behind, in one browser's theme."""

    def __init__(self, client: viser.ClientHandle, workspace: Workspace) -> None:
        self._is_dark = False
        self._arrow = ArrowView(
            client.scene,
            "/ghost",
            surface(False).ghost,
            thickness=0.007,
            height=_GHOST_HEIGHT,
            length=workspace.push_length,
        )

    def update(self, push: Push | None, is_dark: bool) -> None:
        """Lie along a push; None, or a push of no length, hides the arrow."""
        if push is not None and push.length > 0.0:
            self._arrow.place(push.start)
            self._arrow.turn(push.direction)
            self._arrow.stretch(push.length)
        self._arrow.show(push is not None and push.length > 0.0)
        if is_dark != self._is_dark:
            self._is_dark = is_dark
            self._arrow.paint(surface(is_dark).ghost)
