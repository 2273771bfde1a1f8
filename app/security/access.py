"""Which requests are let in: Host, Origin and the token."""

import hashlib
import hmac
import http
import ipaddress
import socket
from dataclasses import dataclass
from urllib.parse import parse_qs, urlsplit

from websockets.datastructures import Headers
from websockets.http11 import Request, Response

LOOPBACK_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})
WILDCARDS = frozenset({"", "0.0.0.0", "::"})
FOREIGN_SOURCES = ("websocket", "playbackPath")
"""Keys by which a link could make viser's page talk to a stranger's server in our origin."""


@dataclass(frozen=True)
class AccessPolicy:
    """What a request has to show.

    Attributes:
        host: Address that the server listens on.
        port: Port that it listens on.
        token: Secret that a browser has to know; None where everybody on this machine may look.
    """

    host: str
    port: int
    token: str | None = None

    @property
    def url(self) -> str:
        """Address to open, token included."""
        name = "127.0.0.1" if self.host in WILDCARDS else self.host
        name = f"[{name}]" if ":" in name else name
        query = f"/?token={self.token}" if self.token else ""
        return f"http://{name}:{self.port}{query}"

    @property
    def cookie_name(self) -> str:
        """Cookies are shared by all ports of a host: the port keeps two laboratories apart."""
        return f"singulate_{self.port}"

    @property
    def cookie_value(self) -> str:
        """A proof of the token that does not reveal it."""
        return hashlib.sha256(f"singulate:{self.token}".encode()).hexdigest()

    def allows_host(self, header: str) -> bool:
        """Whether a Host header names this machine rather than a name rebound to it."""
        try:
            parts = urlsplit(f"//{header}")
            name, _ = parts.hostname, parts.port
        except ValueError:
            return False
        if name is None or parts.username is not None or parts.path:
            return False
        if name in LOOPBACK_NAMES or name == self.host.lower():
            return True
        return self.host in WILDCARDS and (_is_address(name) or name == socket.gethostname())

    def allows_origin(self, origin: str, host_header: str) -> bool:
        """Whether a page of this very server sent the request."""
        host = host_header.lower()
        return origin.lower() in (f"http://{host}", f"https://{host}")

    def knows_token(self, token: str) -> bool:
        """Compare in constant time."""
        return self.token is not None and hmac.compare_digest(token.encode(), self.token.encode())

    def holds_cookie(self, cookie_header: str) -> bool:
        """Whether one of the cookies proves the token."""
        pairs = (pair.strip().partition("=") for pair in cookie_header.split(";"))
        return any(
            name == self.cookie_name and hmac.compare_digest(value.encode(), proof)
            for name, _, value in pairs
            for proof in (self.cookie_value.encode(),)
        )


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach an address."""
    if host == "localhost":
        return True
    return _is_address(host) and ipaddress.ip_address(host).is_loopback


def answer_request(policy: AccessPolicy, request: Request) -> Response | None:
    """Judge a request before anything else looks at it.

    Args:
        policy: What a request has to show.
        request: A page or file request, or the opening of a websocket.

    Returns:
        A refusal, the answer to a link with the token, or None where the request may pass.
    """
    is_websocket = request.headers.get("Upgrade", "").lower() == "websocket"
    query = parse_qs(urlsplit(request.path).query, keep_blank_values=True)
    fault = _fault(policy, request.headers, is_websocket) or _query_fault(query)
    if fault:
        return _refusal(fault)
    if policy.token is None or any(map(policy.holds_cookie, request.headers.get_all("Cookie"))):
        return None
    if not is_websocket and any(map(policy.knows_token, query.get("token", []))):
        return _entrance(policy)
    return _refusal("Open the address that was printed when the laboratory was started.")


def _fault(policy: AccessPolicy, headers: Headers, is_websocket: bool) -> str:
    hosts, origins = headers.get_all("Host"), headers.get_all("Origin")
    if len(hosts) != 1 or not policy.allows_host(hosts[0]):
        return "This address is not one of the laboratory's."
    if len(origins) > 1 or (is_websocket and not origins):
        return "A websocket has to say which page it belongs to."
    if origins and not policy.allows_origin(origins[0], hosts[0]):
        return "Only the laboratory's own page may connect."
    return ""


def _query_fault(query: dict[str, list[str]]) -> str:
    if any(key in query for key in FOREIGN_SOURCES):
        return "The page connects to its own server only."
    return ""


def _refusal(reason: str) -> Response:
    body = f"{reason}\n".encode()
    headers = Headers(
        [("Content-Type", "text/plain; charset=utf-8"), ("Content-Length", str(len(body)))]
    )
    return Response(http.HTTPStatus.FORBIDDEN, "Forbidden", headers, body)


def _entrance(policy: AccessPolicy) -> Response:
    # A redirect would keep the first request's cross-site mark, and browsers would then hold the
    # strict cookie back; a page that moves on by itself is our own site, and takes the token out
    # of the address.
    body = b'<!doctype html><meta http-equiv="refresh" content="0;url=/">'
    cookie = f"{policy.cookie_name}={policy.cookie_value}; Path=/; HttpOnly; SameSite=Strict"
    headers = Headers(
        [
            ("Content-Type", "text/html; charset=utf-8"),
            ("Content-Length", str(len(body))),
            ("Set-Cookie", cookie),
            ("Cache-Control", "no-store"),
            ("Referrer-Policy", "no-referrer"),
        ]
    )
    return Response(http.HTTPStatus.OK, "OK", headers, body)


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
