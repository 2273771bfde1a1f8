"""The pusher, and the name of the person who moves it, or a block."""

import math

import viser

from app.views.palette import PUSHER_COLOUR
from singulate.simulation.physics import Physics

PUSHER_SIDE = Physics().pusher_side
PUSHER_HEIGHT = Physics().pusher_height
"""Size of the pusher [m]."""


class PusherView:
    """A small metal box that is there while it pushes."""

    def __init__(self, scene: viser.SceneApi) -> None:
        self._box = scene.add_box(
            "/pusher",
            PUSHER_COLOUR,
            (PUSHER_SIDE, PUSHER_SIDE, PUSHER_HEIGHT),
            visible=False,
            cast_shadow=False,
        )
        self._shown: tuple[float, float, float, float] | None = None

    def update(self, pose: tuple[float, float, float, float] | None) -> None:
        """Show the pusher at (x, y, z, yaw), or lifted away."""
        if pose == self._shown:
            return
        self._shown = pose
        if pose is not None:
            x, y, z, yaw = pose
            self._box.position = (x, y, z)
            self._box.wxyz = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
        if self._box.visible != (pose is not None):
            self._box.visible = pose is not None


class ActorNameView:
    """Says above the pusher or a block who is moving it, in the browsers of the others.

    The label is only there while it is shown: viser writes to all labels for each picture, hidden
    ones too, so that a browser cannot tell which part of its picture has changed.
    """

    def __init__(self, scene: viser.SceneApi) -> None:
        self._scene = scene
        self._label: viser.LabelHandle | None = None

    def update(self, name: str, place: tuple[float, float, float] | None) -> None:
        """Show a name at a place (x, y, z) [m]; an empty name or no place takes it away."""
        if not name or place is None:
            if self._label is not None:
                self._label.remove()
                self._label = None
        elif self._label is None:
            self._label = self._scene.add_label(
                "/actor_name", name, anchor="bottom-center", font_screen_scale=0.9, position=place
            )
        else:
            self._label.position = place
            if self._label.text != name:
                self._label.text = name
