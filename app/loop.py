"""The main loop: laboratory in, pages out."""

import logging
import queue
import threading
import time

import viser

from app.commands import Command
from app.laboratory import Laboratory
from app.session import ClientSession
from app.snapshot import Snapshot
from app.views.blocks import BlocksView
from app.views.light import add_lights
from app.views.pusher import PusherView
from singulate.geometry import Workspace

PERIOD_S = 1.0 / 30.0

_log = logging.getLogger(__name__)


class Dashboard:
    """Draws what the laboratory reports, thirty times a second, for every browser.

    Everything happens on the thread that calls `run`; browsers that come and go are put in a
    queue, and commands wake the loop so that a click does not wait for the next period.

    Args:
        server: viser's server.
        laboratory: The one owner of the state.
        workspace: The table.
    """

    def __init__(
        self,
        server: viser.ViserServer,
        laboratory: Laboratory,
        workspace: Workspace | None = None,
    ) -> None:
        self._server = server
        self._laboratory = laboratory
        self._workspace = workspace or Workspace()
        self._arrivals: queue.SimpleQueue[viser.ClientHandle] = queue.SimpleQueue()
        self._departures: queue.SimpleQueue[int] = queue.SimpleQueue()
        self._sessions: dict[int, ClientSession] = {}
        self._num_visitors = 0
        self._wake = threading.Event()
        add_lights(server.scene)
        self._blocks = BlocksView(server.scene, self._workspace)
        self._pusher = PusherView(server.scene)
        server.on_client_connect(self._arrive)
        server.on_client_disconnect(self._leave)

    def run(self, stop: threading.Event) -> None:
        """Work until `stop` is set; `submit` and `stop` both wake the loop."""
        while not stop.is_set():
            begin = time.monotonic()
            self.step()
            if self._wake.wait(max(0.0, PERIOD_S - (time.monotonic() - begin))):
                self._wake.clear()

    def step(self) -> None:
        """One round: who came and went, what happened, what it looks like."""
        self._welcome()
        snapshot = self._laboratory.tick()
        with self._server.atomic():
            self._draw_shared(snapshot)
        for client_id, session in list(self._sessions.items()):
            self._draw(client_id, session, snapshot)
        wanted = {
            name for session in self._sessions.values() for name in session.page.wanted_fields
        }
        self._laboratory.set_wanted_fields(wanted)

    def submit(self, command: Command) -> None:
        """Take a command to the laboratory; any thread may call this."""
        self._laboratory.submit(command)
        self._wake.set()

    def _draw_shared(self, snapshot: Snapshot) -> None:
        if snapshot.scene is not None:
            self._blocks.update(snapshot.scene.poses)
            self._pusher.update(snapshot.scene.pusher)

    def _draw(self, client_id: int, session: ClientSession, snapshot: Snapshot) -> None:
        try:
            with session.client.atomic():
                session.update(snapshot)
        except Exception:
            _log.exception("the page of %s failed and is no longer updated", session.name)
            session.client.add_notification(
                "This page has failed",
                "Reload it to go on. The laboratory and its training are not affected; the "
                "terminal shows what happened.",
                color="red",
            )
            self._sessions.pop(client_id, None)

    def _arrive(self, client: viser.ClientHandle) -> None:
        self._arrivals.put(client)
        self._wake.set()

    def _leave(self, client: viser.ClientHandle) -> None:
        self._departures.put(client.client_id)
        self._wake.set()

    def _welcome(self) -> None:
        while not self._arrivals.empty():
            client = self._arrivals.get()
            self._num_visitors += 1
            name = f"visitor {self._num_visitors}"
            self._sessions[client.client_id] = ClientSession(
                client, name, self.submit, self._workspace
            )
        while not self._departures.empty():
            session = self._sessions.pop(self._departures.get(), None)
            if session is not None:
                session.close()
