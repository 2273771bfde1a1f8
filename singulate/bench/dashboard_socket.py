"""The dashboard without a browser: its own messages over a websocket, so that nothing is drawn."""

import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib.metadata import version
from typing import Any

import msgspec.msgpack
import zstandard
from websockets.sync.client import connect
from websockets.sync.connection import Connection
from websockets.typing import Origin, Subprotocol

_TIMEOUT_S = 30.0
_QUIET_S = 1.0
_LENGTHS = 16
"""Bytes before the compressed part of a message: its length without and with compression."""

_CAMERA: dict[str, Any] = {
    "type": "ViewerCameraMessage",
    "wxyz": (0.0, 1.0, 0.0, 0.0),
    "position": (0.0, 0.0, 3.0),
    "fov": 0.8,
    "near": 0.01,
    "far": 100.0,
    "image_height": 720,
    "image_width": 652,
    "look_at": (0.0, 0.0, 0.0),
    "up_direction": (0.0, 1.0, 0.0),
}


@contextmanager
def open_socket(url: str) -> Iterator["DashboardSocket"]:
    """Connect to the dashboard as a page does and wait until it takes clicks."""
    authority = url.split("://")[1].strip("/")
    with connect(
        f"ws://{authority}",
        origin=Origin(f"http://{authority}"),
        subprotocols=[Subprotocol(f"viser-v{version('viser')}")],
        max_size=None,
        max_queue=None,  # also a page that nobody reads stays connected
    ) as connection:
        connection.send(msgspec.msgpack.encode(_CAMERA))
        while not any(
            message["type"] == "ScenePointerEnableMessage"
            for message in _messages(connection.recv(timeout=_TIMEOUT_S))
        ):
            continue
        yield DashboardSocket(connection)


class DashboardSocket:
    """A page that draws nothing; see `open_socket`."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection

    def click(self, x: float, y: float) -> float:
        """Click on the table once the pusher is at rest.

        Args:
            x: Where, from left to right [m].
            y: Where, from below to above [m].

        Returns:
            Time until the pusher's first motion has arrived [s].

        Raises:
            TimeoutError: If it does not move.
        """
        self._wait_for_rest()
        begin = time.monotonic()
        message = {
            "type": "ScenePointerMessage",
            "event_type": "click",
            "ray_origin": (x, y, 3.0),
            "ray_direction": (0.0, 0.0, -1.0),
            "screen_pos": ((0.5, 0.5),),
            "modifier": None,
        }
        self._connection.send(msgspec.msgpack.encode(message))
        while not _moves_pusher(self._connection.recv(timeout=_TIMEOUT_S)):
            if time.monotonic() - begin > _TIMEOUT_S:
                raise TimeoutError("the pusher does not move")
        return time.monotonic() - begin

    def num_bytes(self, seconds: float) -> int:
        """Bytes that the page is sent in some time."""
        return sum(map(len, self._receive(seconds)))

    def wait_until_calm(self, seconds: float, num_bytes: int) -> None:
        """Wait until the page is sent no more than so many bytes in some time.

        Raises:
            TimeoutError: If that does not happen.
        """
        give_up = time.monotonic() + 2 * _TIMEOUT_S
        while self.num_bytes(seconds) > num_bytes:
            if time.monotonic() > give_up:
                raise TimeoutError("the page is sent more and more")

    def _receive(self, seconds: float) -> Iterator[bytes | str]:
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0.0:
            with suppress(TimeoutError):
                yield self._connection.recv(timeout=left)

    def _wait_for_rest(self) -> None:
        last_motion = time.monotonic()
        while (left := last_motion + _QUIET_S - time.monotonic()) > 0.0:
            with suppress(TimeoutError):
                if _moves_pusher(self._connection.recv(timeout=left)):
                    last_motion = time.monotonic()


def _moves_pusher(data: bytes | str) -> bool:
    return any(
        message["type"] == "SetPositionMessage" and message["name"] == "/pusher"
        for message in _messages(data)
    )


def _messages(data: bytes | str) -> list[dict[str, Any]]:
    assert isinstance(data, bytes)
    size = int.from_bytes(data[:8], "little")
    packed = int.from_bytes(data[8:_LENGTHS], "little")
    plain = zstandard.decompress(data[_LENGTHS : _LENGTHS + packed], max_output_size=size)
    messages: list[dict[str, Any]] = msgspec.msgpack.decode(plain)["messages"]
    return messages
