"""viser's server behind our own door."""

import contextlib
import errno
import gzip
import http
import socket
from collections.abc import Awaitable, Callable, Iterator
from typing import Any

import rich
import viser
import websockets.asyncio.server
from viser import _messages
from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

from app.security import AccessPolicy, GuardedConnection, answer_request
from singulate.exceptions import InvalidValueError

MAX_MESSAGE_BYTES = 8 * 1024 * 1024
"""Largest message that a browser may send; a rendered picture is the largest that it does."""

SECURITY_HEADERS = (
    ("Content-Security-Policy", "frame-ancestors 'none'"),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
)

Handler = Callable[[Any], Awaitable[None]]
Dress = Callable[[bytes], bytes]
"""From viser's page, HTML, to the one that is sent."""


def bind(host: str, port: int) -> socket.socket:
    """Take an address before anything is started.

    Args:
        host: Name or address to listen on.
        port: Port; 0 for a free one.

    Raises:
        InvalidValueError: If the address is unknown or the port is taken.
    """
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
    except (OSError, UnicodeError):
        raise InvalidValueError("--host", host, "an address of this machine") from None
    listener = socket.socket(family, kind, protocol)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen()
    except PermissionError:
        listener.close()
        raise InvalidValueError(
            "--port", port, "a port from 1024 on, or 0 for a free one"
        ) from None
    except OSError as error:
        listener.close()
        raise _refused(error, host, port) from None
    return listener


def open_server(
    listener: socket.socket,
    policy: AccessPolicy,
    on_handled: Callable[[], None] = lambda: None,
    dress: Dress = lambda page: page,
) -> viser.ViserServer:
    """Start viser on a bound socket.

    viser 1.1.1 has no door of its own: the websocket server that it makes is wrapped while it is
    constructed, so that every request is judged first, every message is checked, and the socket
    is the one that was bound.

    Args:
        listener: The socket.
        policy: Who may come in.
        on_handled: Called, on viser's thread, after a browser's message has been handled.
        dress: Gives viser's page, as it is sent, whatever else it should have; on viser's thread.
    """
    rich.get_console().quiet = True  # viser announces itself on standard output
    with _guarded_serve(listener, policy, on_handled, dress) as registry:
        server = viser.ViserServer(policy.host, policy.port, label="Singulate", verbose=False)
        registry.append(server)
    for message in (_messages.ShareUrlRequest, _messages.ShareUrlDisconnect):
        server._websock_server.unregister_handler(message)
    return server


def _refused(error: OSError, host: str, port: int) -> InvalidValueError:
    if error.errno == errno.EADDRINUSE:
        return InvalidValueError(
            "--port", f"{port}, which another program uses", "a free port, or 0 to be given one"
        )
    return InvalidValueError("--host", host, "an address of this machine")


@contextlib.contextmanager
def _guarded_serve(
    listener: socket.socket, policy: AccessPolicy, on_handled: Callable[[], None], dress: Dress
) -> Iterator[list[viser.ViserServer]]:
    original = websockets.asyncio.server.serve
    registry: list[viser.ViserServer] = []

    def serve(handler: Handler, host: str, port: int, **options: Any) -> Any:
        options["process_request"] = _judged(options["process_request"], policy, dress)
        options["max_size"] = MAX_MESSAGE_BYTES
        return original(_checked(handler, registry, on_handled), sock=listener, **options)

    websockets.asyncio.server.serve = serve  # type: ignore[misc, assignment]
    try:
        yield registry
    finally:
        websockets.asyncio.server.serve = original  # type: ignore[misc]


def _judged(
    serve_file: Callable[[ServerConnection, Request], Response | None],
    policy: AccessPolicy,
    dress: Dress,
) -> Callable[[ServerConnection, Request], Response | None]:
    def process_request(connection: ServerConnection, request: Request) -> Response | None:
        response = answer_request(policy, request)
        if response is None:
            response = serve_file(connection, request)
            if response is not None and response.status_code == http.HTTPStatus.OK:
                _dress_page(response, dress)
        if response is not None:
            for name, value in SECURITY_HEADERS:
                if name not in response.headers:
                    response.headers[name] = value
        return response

    return process_request


def _dress_page(response: Response, dress: Dress) -> None:
    headers = response.headers
    if not headers["Content-Type"].startswith("text/html"):
        return
    is_packed = headers["Content-Encoding"] == "gzip"
    page = dress(gzip.decompress(response.body) if is_packed else bytes(response.body))
    response.body = gzip.compress(page, compresslevel=1) if is_packed else page
    del headers["Content-Length"]
    headers["Content-Length"] = str(len(response.body))
    headers["Cache-Control"] = "no-cache"


def _checked(
    handler: Handler, registry: list[viser.ViserServer], on_handled: Callable[[], None]
) -> Handler:
    async def handle(connection: ServerConnection) -> None:
        guarded: GuardedConnection

        def find_input(uuid: str) -> Any | None:
            return _find_input(registry[0], guarded, uuid) if registry else None

        guarded = GuardedConnection(connection, find_input, on_handled)
        await handler(guarded)

    return handle


def _find_input(server: viser.ViserServer, connection: GuardedConnection, uuid: str) -> Any | None:
    """The shared input with a uuid, or the one that only this connection's page has."""
    shared = server.gui._gui_input_handle_from_uuid.get(uuid)
    if shared is not None:
        return shared
    live: dict[Any, Any] = dict(server._websock_server._live_connections)
    for client_id, candidate in live.items():
        client = server._connected_clients.get(client_id)
        if candidate is connection and client is not None:
            return client.gui._gui_input_handle_from_uuid.get(uuid)
    return None
