"""Who is let in: real HTTP requests and websockets against a real server."""

import http.client
from collections.abc import Callable
from typing import Any

import pytest
from websockets.exceptions import InvalidStatus

from app.security import AccessPolicy
from app.security.access import is_loopback

TOKEN = "a-secret-of-the-test"


def get(door: Any, path: str = "/", **headers: str) -> http.client.HTTPResponse:
    connection = http.client.HTTPConnection("127.0.0.1", door.policy.port, timeout=10)
    connection.request("GET", path, headers={"Host": door.authority, **headers})
    response = connection.getresponse()
    response.read()
    connection.close()
    return response


def refusal(knock: Callable[[], object]) -> int:
    with pytest.raises(InvalidStatus) as refused:
        knock()
    return int(refused.value.response.status_code)


def test_the_own_page_is_served_and_may_connect(door: Any) -> None:
    response = get(door)
    assert response.status == 200
    assert response.headers["Content-Security-Policy"] == "frame-ancestors 'none'"
    assert response.headers["X-Content-Type-Options"] == "nosniff"
    assert len(door.knock().recv(timeout=10)) > 0


@pytest.mark.parametrize("origin", ["http://evil.example", "http://localhost:1", "null", ""])
def test_pages_of_others_may_not_connect(door: Any, origin: str) -> None:
    assert refusal(lambda: door.knock(origin=origin)) == 403
    door.knock()


def test_a_name_rebound_to_this_machine_is_refused(door: Any) -> None:
    assert get(door, Host=f"evil.example:{door.policy.port}").status == 403
    assert get(door, Host=f"localhost:{door.policy.port}").status == 200


def test_a_forwarded_port_is_still_the_same_site(door: Any) -> None:
    assert get(door, Host="localhost:9999", Origin="http://localhost:9999").status == 200
    assert get(door, Host="localhost:9999", Origin="http://localhost:9998").status == 403


@pytest.mark.parametrize("key", ["websocket", "playbackPath"])
def test_a_link_cannot_point_the_page_at_a_strangers_server(door: Any, key: str) -> None:
    assert get(door, f"/?{key}=ws://evil.example").status == 403
    assert get(door, "/?other=1").status == 200


def test_the_token_is_asked_for_and_becomes_a_strict_cookie(
    make_door: Callable[..., Any],
) -> None:
    door = make_door(TOKEN)
    assert get(door).status == 403
    assert get(door, "/?token=wrong-one").status == 403
    assert refusal(door.knock) == 403

    entrance = get(door, f"/?token={TOKEN}")
    assert entrance.status == 200
    cookie, *attributes = entrance.headers["Set-Cookie"].split("; ")
    assert {"HttpOnly", "SameSite=Strict", "Path=/"} <= set(attributes)
    assert TOKEN not in cookie

    assert get(door, Cookie=f"other=1; {cookie}").status == 200
    assert len(door.knock(Cookie=cookie).recv(timeout=10)) > 0
    assert get(door, Cookie=f"{cookie[:-1]}x").status == 403
    assert refusal(lambda: door.knock(Cookie=f"{cookie[:-1]}x")) == 403
    assert refusal(lambda: door.knock(origin="http://evil.example", Cookie=cookie)) == 403


def test_a_websocket_cannot_bring_the_token_in_its_address(make_door: Callable[..., Any]) -> None:
    door = make_door(TOKEN)
    assert get(door, f"/?token={TOKEN}", Upgrade="websocket").status == 403


def test_the_printed_address_opens_the_page() -> None:
    assert AccessPolicy("127.0.0.1", 80).url == "http://127.0.0.1:80"
    assert AccessPolicy("0.0.0.0", 80, TOKEN).url == f"http://127.0.0.1:80/?token={TOKEN}"
    assert AccessPolicy("::1", 80).url == "http://[::1]:80"


def test_open_addresses_accept_addresses_but_no_foreign_names() -> None:
    policy = AccessPolicy("0.0.0.0", 80, TOKEN)
    assert policy.allows_host("192.168.1.7:80")
    assert policy.allows_host("[fe80::1]:80")
    assert not policy.allows_host("evil.example:80")
    assert not AccessPolicy("127.0.0.1", 80).allows_host("192.168.1.7:80")


@pytest.mark.parametrize(
    "header", ["", "a b", "localhost:port", "x@localhost", "[::1", "localhost/x"]
)
def test_malformed_hosts_are_refused(header: str) -> None:
    assert not AccessPolicy("127.0.0.1", 80).allows_host(header)


def test_only_loopback_addresses_need_no_token() -> None:
    assert all(map(is_loopback, ["127.0.0.1", "127.8.8.8", "::1", "localhost"]))
    assert not any(map(is_loopback, ["0.0.0.0", "192.168.1.7", "", "example.com", "::"]))
