"""Arrows on the table: the push that is aimed at, and the last one's ghost."""

import math

import numpy as np
import numpy.typing as npt
import viser

from app.views.palette import AIM_COLOUR, Colour, surface
from singulate.geometry import Push

_HEIGHT = 0.012
_GHOST_HEIGHT = 0.008


class ArrowView:
    """One flat arrow that is moved, turned and hidden in place.

    Args:
        scene: Where it is drawn.
        name: Its node.
        colour: Its colour.
        thickness: Radius of its shaft [m].
        height: How far above the table it lies [m].
    """

    def __init__(
        self, scene: viser.SceneApi, name: str, colour: Colour, thickness: float, height: float
    ) -> None:
        self._height = height
        self._length = 0.5
        self._shown: Push | None = None
        self._arrow = scene.add_arrows(
            name,
            _along_x(self._length),
            colour,
            shaft_radius=thickness,
            head_radius=3.2 * thickness,
            head_length=7.0 * thickness,
            scale=(1.0, 1.0, 0.15),
            visible=False,
        )

    def paint(self, colour: Colour) -> None:
        """Change its colour."""
        self._arrow.colors = np.array(colour, dtype=np.uint8)

    def update(self, push: Push | None) -> None:
        """Lie along a push; None, or a push of no length, hides the arrow."""
        if push == self._shown:
            return
        self._shown = push
        is_visible = push is not None and push.length > 0.0
        if push is not None and is_visible:
            self._lie_along(push)
        if self._arrow.visible != is_visible:
            self._arrow.visible = is_visible

    def _lie_along(self, push: Push) -> None:
        self._arrow.position = (*push.start, self._height)
        self._arrow.wxyz = (math.cos(push.yaw / 2), 0.0, 0.0, math.sin(push.yaw / 2))
        if push.length != self._length:
            self._length = push.length
            self._arrow.points = _along_x(push.length)


def aim_arrow(scene: viser.SceneApi) -> ArrowView:
    """The arrow of the push that a person aims at."""
    return ArrowView(scene, "/aim", AIM_COLOUR, 0.012, _HEIGHT)


def ghost_arrow(scene: viser.SceneApi) -> ArrowView:
    """The arrow that the last push leaves behind."""
    return ArrowView(scene, "/ghost", surface(False).ghost, 0.007, _GHOST_HEIGHT)


def _along_x(length: float) -> npt.NDArray[np.float32]:
    return np.array([[[0.0, 0.0, 0.0], [length, 0.0, 0.0]]], dtype=np.float32)
