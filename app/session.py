"""One browser: its page, its aim, and what it alone sees of the table."""

from collections.abc import Callable

import viser

from app.aim import Aim
from app.block_pointer import BlockPointer
from app.commands import Command, PushNow
from app.page import ClientPage
from app.page_script import run_script
from app.pointer import Point, Pointer, PointerActions
from app.snapshot import SceneSnapshot, Snapshot
from app.views.arrows import AimView, GhostView
from app.views.camera import CameraView
from app.views.field import FIELD_NODE, FieldView
from app.views.pusher import PUSHER_HEIGHT, ActorNameView
from app.views.table import RimView
from singulate.geometry import Push, Workspace


class ClientSession:
    """All that is made when a browser connects and forgotten when it leaves.

    Args:
        client: The browser.
        name: What the others call this person.
        submit: Takes commands to the laboratory.
        workspace: The table.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        name: str,
        submit: Callable[[Command], None],
        workspace: Workspace,
    ) -> None:
        self.client = client
        self.name = name
        self.page = ClientPage(client, submit, name)
        self._submit = submit
        self._workspace = workspace
        self._start: Point | None = None
        self._scene: SceneSnapshot | None = None
        run_script(client, "redraw.js", field=FIELD_NODE)
        self._rim = RimView(client.scene, workspace)
        self._field = FieldView(client.scene, workspace)
        self._aim_view = AimView(client, workspace)
        self._ghost = GhostView(client, workspace)
        self._actor_name = ActorNameView(client.scene)
        actions = PointerActions(self._click, self._take_aim, self._release)
        self._pointer = Pointer(client, self._field.image, workspace, actions)
        self._block_pointer = BlockPointer(client, workspace, name, submit)
        self._camera = CameraView(client, workspace)
        top = client.gui.add_command("View from the top, and back", hotkey="C")
        top.on_trigger(lambda _: self._camera.switch())

    @property
    def aim(self) -> Aim:
        """Where this person's next push would start, and in which direction."""
        return Aim(self._start, self.page.direction)

    def update(self, snapshot: Snapshot) -> None:
        """Show a snapshot."""
        self._camera.update()
        self.page.update(snapshot)
        is_dark = self.page.is_dark
        self._rim.update(is_dark)
        self._field.update(self.page.draped, is_dark)
        self._scene = scene = snapshot.scene
        is_free = scene is not None and not scene.is_pushing and scene.held_by != self.name
        self._aim_view.update(self.aim, is_shown=is_free)
        if scene is not None:
            self._ghost.update(_ghost(scene), is_dark)
            name, place = _actor(scene)
            self._actor_name.update("" if name == self.name else name, place)

    def drag_block(self, index: int, event: viser.SceneNodeDragEvent[viser.BoxHandle]) -> None:
        """Follow this person's drag of a block."""
        scene = self._scene
        if scene is not None and index < len(scene.poses):
            self.page.choose_block(index)
            self._block_pointer.drag(index, scene.poses[index], event)

    def close(self) -> None:
        """Let go of the page, and of the block that its person held."""
        self._block_pointer.release()
        self.page.close()

    def _click(self, point: Point) -> None:
        if self.page.inspect(point):
            return
        self._start = point
        self._push(self.aim)

    def _take_aim(self, aim: Aim | None) -> None:
        if aim is not None:
            self._start = aim.start
            self.page.set_direction(aim.direction)

    def _release(self, aim: Aim) -> None:
        self._take_aim(aim)
        self._push(aim)

    def _push(self, aim: Aim) -> None:
        push = aim.push(self._workspace)
        if push is not None:
            self._submit(PushNow(push, by=self.name))


def _ghost(scene: SceneSnapshot) -> Push | None:
    if scene.is_pushing:
        return scene.active_push
    return None if scene.last_push is None else scene.last_push.push


def _actor(scene: SceneSnapshot) -> tuple[str, tuple[float, float, float] | None]:
    """Who is moving something, and the place above it [m]."""
    if scene.pusher is not None:
        x, y, z, _ = scene.pusher
        return scene.pushed_by, (x, y, z + PUSHER_HEIGHT)
    if scene.held_block is not None and scene.held_block < len(scene.poses):
        pose = scene.poses[scene.held_block]
        x, y, z = pose.position
        return scene.held_by, (x, y, z + pose.side)
    return "", None
