"""The main loop: laboratory in, pages out."""

import contextlib
import logging
import queue
import threading
import time
from collections.abc import Callable

import viser

from app.laboratory import Laboratory
from app.session import ClientSession
from app.snapshot import Snapshot
from app.views.blocks import BlocksView
from app.views.camera import set_initial_camera
from app.views.light import add_lights
from app.views.pusher import PusherView
from singulate.geometry import Workspace

SHORTEST_PERIOD_S = 1.0 / 60.0
USUAL_PERIOD_S = 1.0 / 30.0
CALM_PERIOD_S = 0.25
CALM_AFTER_S = 1.0
"""Without news for this long [s], there is nothing left to draw but what changes with the clock."""

_log = logging.getLogger(__name__)


class Dashboard:
    """Draws what the laboratory reports, for every browser.

    Everything happens on the thread that calls `run`, which also has to be the one that made the
    laboratory; browsers that come and go are put in a queue, and so are their commands.

    Args:
        server: viser's server.
        laboratory: The one owner of the state.
        workspace: The table.
        on_snapshot: Told of every snapshot that is drawn.
    """

    def __init__(
        self,
        server: viser.ViserServer,
        laboratory: Laboratory,
        workspace: Workspace | None = None,
        on_snapshot: Callable[[Snapshot], None] = lambda _: None,
    ) -> None:
        self._server = server
        self._laboratory = laboratory
        self._workspace = workspace or Workspace()
        self._on_snapshot = on_snapshot
        self._arrivals: queue.SimpleQueue[viser.ClientHandle] = queue.SimpleQueue()
        self._departures: queue.SimpleQueue[int] = queue.SimpleQueue()
        self._sessions: dict[int, ClientSession] = {}
        self._num_visitors = 0
        set_initial_camera(server, self._workspace)
        add_lights(server.scene)
        self._blocks = BlocksView(server.scene, self._drag_block)
        self._pusher = PusherView(server.scene)
        server.on_client_connect(self._arrive)
        server.on_client_disconnect(self._leave)

    def run(self, stop: threading.Event) -> None:
        """Work until `stop` is set.

        Draws up to 60 times a second while there is news, 30 times shortly after, and 4 times on a
        calm page, of which there may be many, and which must not slow down a training. What arrives
        between two pictures is passed on at once all the same.
        """
        last_news = time.monotonic()
        while not stop.is_set():
            begin = time.monotonic()
            self.step()
            is_calm = begin - last_news > CALM_AFTER_S
            if self._laboratory.wait(CALM_PERIOD_S if is_calm else USUAL_PERIOD_S):
                last_news = time.monotonic()
            while (early := begin + SHORTEST_PERIOD_S - time.monotonic()) > 0.0:
                self._laboratory.tick()
                self._laboratory.wait(early)

    def step(self) -> None:
        """One round: who came and went, what happened, what it looks like."""
        self._welcome()
        snapshot = self._laboratory.tick()
        self._on_snapshot(snapshot)
        with self._server.atomic():
            self._draw_shared(snapshot)
        self._server.flush()  # otherwise viser waits for more, for a sixtieth of a second
        for client_id, session in list(self._sessions.items()):
            self._draw(client_id, session, snapshot)
        wanted = {
            name for session in self._sessions.values() for name in session.page.wanted_fields
        }
        self._laboratory.set_wanted_fields(wanted)

    def _draw_shared(self, snapshot: Snapshot) -> None:
        if snapshot.scene is not None:
            self._blocks.update(snapshot.scene.poses)
            self._pusher.update(snapshot.scene.pusher)

    def _draw(self, client_id: int, session: ClientSession, snapshot: Snapshot) -> None:
        try:
            with session.client.atomic():
                session.update(snapshot)
            session.client.flush()
        except Exception:
            self._sessions.pop(client_id, None)
            with contextlib.suppress(Exception):
                session.close()
            _report_failure(session.client, session.name)

    def _drag_block(self, index: int, event: viser.SceneNodeDragEvent[viser.BoxHandle]) -> None:
        session = self._sessions.get(event.client_id)
        if session is not None:
            session.drag_block(index, event)

    def _arrive(self, client: viser.ClientHandle) -> None:
        self._arrivals.put(client)
        self._laboratory.wake()

    def _leave(self, client: viser.ClientHandle) -> None:
        self._departures.put(client.client_id)
        self._laboratory.wake()

    def _welcome(self) -> None:
        while not self._arrivals.empty():
            client = self._arrivals.get()
            self._num_visitors += 1
            name = f"visitor {self._num_visitors}"
            try:
                self._sessions[client.client_id] = ClientSession(
                    client, name, self._laboratory.submit, self._workspace
                )
            except Exception:
                _report_failure(client, name)
        while not self._departures.empty():
            session = self._sessions.pop(self._departures.get(), None)
            if session is not None:
                session.close()


def _report_failure(client: viser.ClientHandle, name: str) -> None:
    """One page has failed: say so there, and go on drawing the others."""
    _log.exception("the page of %s failed and is no longer updated", name)
    client.add_notification(
        "This page has failed",
        "Reload it to go on. The laboratory and its training are not affected; the terminal shows "
        "what happened.",
        color="red",
    )
