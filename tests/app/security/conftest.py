"""A real viser server behind the door, and raw clients that knock on it."""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import msgspec.msgpack
import pytest
import viser
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

from app.security import AccessPolicy
from app.server import bind, open_server

CAMERA: dict[str, Any] = {
    "type": "ViewerCameraMessage",
    "wxyz": [1.0, 0.0, 0.0, 0.0],
    "position": [0.0, 0.0, 4.0],
    "fov": 0.5,
    "near": 0.01,
    "far": 1000.0,
    "image_height": 720,
    "image_width": 652,
    "look_at": [0.0, 0.0, 0.0],
    "up_direction": [0.0, 0.0, 1.0],
}


@dataclass
class Door:
    """A guarded server and what it takes to get in."""

    server: viser.ViserServer
    policy: AccessPolicy
    _open: list[ClientConnection] = field(default_factory=list)

    @property
    def authority(self) -> str:
        return f"127.0.0.1:{self.policy.port}"

    def knock(self, origin: str | None = None, **headers: str) -> ClientConnection:
        """Open a websocket as the page does; `origin` and headers replace the page's own."""
        connection = connect(
            f"ws://{self.authority}",
            origin=Origin(f"http://{self.authority}" if origin is None else origin) or None,
            subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
            additional_headers=headers,
            max_size=None,
            close_timeout=1,
        )
        self._open.append(connection)
        return connection

    def enter(self, **headers: str) -> ClientConnection:
        """Open a websocket and report a camera, which makes viser count it as a client."""
        known = set(self.server.get_clients())
        connection = self.knock(**headers)
        send(connection, CAMERA)
        wait_until(lambda: set(self.server.get_clients()) - known)
        return connection

    def close(self) -> None:
        for connection in self._open:
            connection.close()
        self.server.stop()


def send(connection: ClientConnection, message: dict[str, Any]) -> None:
    connection.send(msgspec.msgpack.encode(message))


def wait_until(is_true: Callable[[], object], timeout_s: float = 10.0) -> None:
    deadline = time.monotonic() + timeout_s
    while not is_true():
        assert time.monotonic() < deadline, "what was waited for did not happen"
        time.sleep(0.01)


@pytest.fixture
def make_door() -> Iterator[Callable[..., Door]]:
    doors: list[Door] = []

    def make(token: str | None = None) -> Door:
        listener = bind("127.0.0.1", 0)
        policy = AccessPolicy("127.0.0.1", listener.getsockname()[1], token)
        doors.append(Door(open_server(listener, policy), policy))
        return doors[-1]

    yield make
    for door in doors:
        door.close()


@pytest.fixture
def door(make_door: Callable[..., Door]) -> Door:
    """A door without a token."""
    return make_door()


@pytest.fixture
def tell() -> Callable[[ClientConnection, dict[str, Any]], None]:
    """Sends a message as msgpack."""
    return send


@pytest.fixture
def eventually() -> Callable[[Callable[[], object]], None]:
    """Waits for something to become true."""
    return wait_until
