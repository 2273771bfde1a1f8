"""A websocket that lets only acceptable messages through."""

import asyncio
import logging
from collections.abc import Callable
from typing import Any

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosedError

from app.security.messages import FindInput, is_acceptable

SEND_TIMEOUT_S = 30.0
"""A browser that takes nothing for this long [s] is dropped: it opens the page anew by itself."""

MAX_REPORTED = 10
"""Messages that a browser may have dropped before the log says no more about it."""

_log = logging.getLogger(__name__)


class GuardedConnection:
    """What viser's handler sees of a websocket.

    Args:
        connection: The real websocket.
        find_input: Finds the inputs that this browser has been shown.
        on_handled: Called after a message has been handled.
    """

    def __init__(
        self, connection: ServerConnection, find_input: FindInput, on_handled: Callable[[], None]
    ) -> None:
        self._connection = connection
        self._find_input = find_input
        self._on_handled = on_handled
        self._has_passed_on = False
        self._num_dropped = 0

    @property
    def subprotocol(self) -> str | None:
        """The protocol that was agreed on; viser reads the client's version from it."""
        return self._connection.subprotocol

    async def recv(self) -> bytes:
        """The next acceptable message; the others are dropped."""
        if self._has_passed_on:
            # viser has made a task of the last message, which runs before this call.
            asyncio.get_running_loop().call_soon(self._on_handled)
        while True:
            raw: Any = await self._connection.recv()
            if is_acceptable(raw, self._find_input):
                assert isinstance(raw, bytes)
                self._has_passed_on = True
                return raw
            self._num_dropped += 1
            if self._num_dropped <= MAX_REPORTED:
                _log.warning("dropped a message of %d bytes from a browser", len(raw))

    async def send(self, data: bytes) -> None:
        """Send, or drop a browser that has stopped reading."""
        try:
            async with asyncio.timeout(SEND_TIMEOUT_S):
                await self._connection.send(data)
        except TimeoutError:
            self._connection.transport.abort()
            raise ConnectionClosedError(None, None) from None

    async def close(self, code: int = 1000, reason: str = "") -> None:
        """Close the websocket."""
        await self._connection.close(code, reason)
