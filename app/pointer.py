"""From the mouse to the table: clicks and dragged arrows."""

from collections.abc import Callable
from dataclasses import dataclass

import viser

from app.aim import Aim, aim_of_drag
from singulate.geometry import Workspace

Point = tuple[float, float]
Point3 = tuple[float, float, float]


def table_point(origin: Point3, direction: Point3, height: float = 0.0) -> Point | None:
    """Where a ray meets the level at some height above the table, (x, y) [m].

    Args:
        origin: Where the ray begins [m].
        direction: Of any length.
        height: Of the level [m].

    Returns:
        None where it does not meet it.
    """
    if abs(direction[2]) < 1e-9:
        return None
    distance = (height - origin[2]) / direction[2]
    if distance <= 0.0:
        return None
    return origin[0] + distance * direction[0], origin[1] + distance * direction[1]


def seen_at(client: viser.ClientHandle, point: Point3, height: float = 0.0) -> Point | None:
    """The place at some height [m] that a point in the air covers, as a browser's camera sees it.

    viser reports drags as points in the air, on a plane that faces the camera.
    """
    x, y, z = (float(value) for value in client.camera.position)
    return table_point((x, y, z), (point[0] - x, point[1] - y, point[2] - z), height)


@dataclass(frozen=True)
class PointerActions:
    """What a person's pointer can do.

    Attributes:
        click: A place on the table was clicked (x, y) [m].
        aim: An arrow is being dragged; None when it has become too short to mean anything.
        release: A dragged arrow was let go.
    """

    click: Callable[[Point], None]
    aim: Callable[[Aim | None], None]
    release: Callable[[Aim], None]


class Pointer:
    """Listens to one browser.

    A left click anywhere over the workspace counts, on a block too: the ray is followed down to
    the table. Dragging with the left button on the workspace draws an arrow; next to it, or with
    another button, it moves the camera.

    Args:
        client: The browser.
        surface: What it draws of the workspace.
        workspace: Clicks outside it are ignored.
        actions: What to do.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        surface: viser.ImageHandle,
        workspace: Workspace,
        actions: PointerActions,
    ) -> None:
        self._client = client
        self._workspace = workspace
        self._actions = actions
        self._drag_start: Point | None = None
        client.scene.on_click()(self._on_click)  # type: ignore[arg-type]  # viser takes both
        surface.on_drag("left")(self._on_drag)

    # viser runs coroutine callbacks in order on its event loop and plain ones in a pool of
    # threads, where the phases of a drag overtake each other: so these are coroutines that never
    # wait.

    async def _on_click(self, event: viser.SceneClickEvent) -> None:
        point = table_point(event.ray_origin, event.ray_direction)
        if point is not None and self._workspace.contains(*point):
            self._actions.click(point)

    async def _on_drag(self, event: viser.SceneNodeDragEvent[viser.ImageHandle]) -> None:
        if event.phase == "start":
            self._drag_start = event.start_position[:2]
        end = seen_at(self._client, event.end_position)
        if self._drag_start is None or end is None:
            return
        aim = aim_of_drag(self._drag_start, end, self._workspace)
        if event.phase != "end":
            self._actions.aim(aim)
            return
        self._drag_start = None
        if aim is None:
            self._actions.aim(None)
        else:
            self._actions.release(aim)
