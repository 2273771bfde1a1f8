"""Where a browser looks from."""

import math
from typing import NamedTuple

import numpy as np
import viser

from app.views.table import MARGIN
from singulate.geometry import Workspace

FIELD_OF_VIEW = math.radians(32.0)
"""Narrow, so that the far side of the table is hardly smaller than the near one."""
TILT = math.radians(20.0)
"""Angle between the initial view and straight down."""
FILL = 0.97
"""Share of the picture that the table may take."""
_USUAL_ASPECT = 0.9
"""Of the picture between the panels of a laptop."""
_ALMOST_STRAIGHT_DOWN = math.radians(0.1)
"""viser's orbit needs a little tilt to know which side is up."""

Point = tuple[float, float, float]


class CameraPose(NamedTuple):
    """A view of the table: where from, and at what [m]."""

    position: Point
    look_at: Point


def tilted_view(workspace: Workspace, aspect: float) -> CameraPose:
    """The view that a page opens with: all of the table, slightly from the front."""
    return _fit(workspace, aspect, TILT)


def top_view(workspace: Workspace, aspect: float) -> CameraPose:
    """The camera's own view: all of the table, from straight above, +y up."""
    return _fit(workspace, aspect, _ALMOST_STRAIGHT_DOWN)


def set_initial_camera(server: viser.ViserServer, workspace: Workspace) -> None:
    """Let pages open with the table in view, before anything is known about their picture."""
    pose = tilted_view(workspace, _USUAL_ASPECT)
    camera = server.initial_camera
    camera.fov = FIELD_OF_VIEW
    camera.position = np.array(pose.position)
    camera.look_at = np.array(pose.look_at)


class CameraView:
    """Keeps the whole table in one browser's picture until its owner moves the camera.

    Panels that dock and windows that change their size change the picture's proportions; the
    camera then steps back or comes closer, unless somebody has moved it by hand.
    """

    def __init__(self, client: viser.ClientHandle, workspace: Workspace) -> None:
        self._client = client
        self._workspace = workspace
        self._aspect = 0.0
        self._view = tilted_view
        self._pose: CameraPose | None = None

    def update(self) -> None:
        """Follow the picture's proportions."""
        aspect = _aspect(self._client)
        if aspect != self._aspect and (self._pose is None or self._is_at(self._pose)):
            self._show(aspect)

    def switch(self) -> None:
        """Take the view from straight above; from there, go back to the tilted one."""
        is_on_top = self._view is top_view and self._pose is not None and self._is_at(self._pose)
        self._view = tilted_view if is_on_top else top_view
        self._show(_aspect(self._client))

    def _show(self, aspect: float) -> None:
        self._aspect = aspect
        self._pose = self._view(self._workspace, aspect)
        camera = self._client.camera
        with self._client.atomic():
            camera.fov = FIELD_OF_VIEW
            camera.up_direction = (0.0, 0.0, 1.0)
            camera.position = self._pose.position
            camera.look_at = self._pose.look_at

    def _is_at(self, pose: CameraPose) -> bool:
        camera = self._client.camera
        return bool(
            np.allclose(camera.position, pose.position, atol=0.02)
            and np.allclose(camera.look_at, pose.look_at, atol=0.02)
        )


def _aspect(client: viser.ClientHandle) -> float:
    height = client.camera.image_height
    return client.camera.image_width / height if height > 0 else 1.0


def _fit(workspace: Workspace, aspect: float, tilt: float) -> CameraPose:
    """The nearest camera that sees all of the table.

    Args:
        workspace: Decides how large the table is.
        aspect: Width of the picture over its height.
        tilt: Angle from straight down [rad].
    """
    reach = workspace.half_length + MARGIN
    near, far = 0.1 * workspace.length, 100.0 * workspace.length
    for _ in range(40):
        middle = (near + far) / 2
        if _share_of_picture(reach, middle, tilt, aspect) > FILL:
            near = middle
        else:
            far = middle
    centre = _vertical_centre(reach, far, tilt)
    y, z = -far * math.sin(tilt), far * math.cos(tilt)
    return CameraPose((0.0, centre + y, z), (0.0, centre, 0.0))


def _vertical_centre(reach: float, distance: float, tilt: float) -> float:
    """The y to look at so that the table's near and far edge are equally far from the middle [m].

    Seen from a distance d at a tilt t, y - c is drawn at (y - c) cos t / (d + (y - c) sin t); that
    this is opposite for the edges at y = -r and y = r makes c² sin t - c d - r² sin t = 0.
    """
    lean = math.sin(tilt) * reach
    return -2.0 * lean * reach / (distance + math.hypot(distance, 2.0 * lean))


def _share_of_picture(reach: float, distance: float, tilt: float, aspect: float) -> float:
    """How far the table's corners reach in the picture, 1 being its edge."""
    above = reach - _vertical_centre(reach, distance, tilt)
    below = 2.0 * reach - above
    half_height = math.tan(FIELD_OF_VIEW / 2)
    nearest = distance - below * math.sin(tilt)
    if nearest <= 0.0:
        return math.inf
    up = above * math.cos(tilt) / (distance + above * math.sin(tilt))
    return max(reach / nearest / aspect, up) / half_height
