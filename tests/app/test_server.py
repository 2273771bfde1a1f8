"""Binding: free, taken and impossible addresses."""

import socket

import pytest

from app.server import bind
from singulate.exceptions import InvalidValueError


def test_port_0_gives_a_free_port() -> None:
    with bind("127.0.0.1", 0) as listener:
        assert listener.getsockname()[1] > 0


def test_a_taken_port_is_one_clear_line() -> None:
    with bind("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        with pytest.raises(InvalidValueError, match=rf"--port: .*{port}.* free port"):
            bind("127.0.0.1", port)
    with bind("127.0.0.1", port) as again:
        assert again.getsockname()[1] == port


@pytest.mark.parametrize("host", ["no.such.host.invalid", "203.0.113.7", "\ud800"])
def test_an_address_of_another_machine_is_refused(host: str) -> None:
    with pytest.raises(InvalidValueError, match="--host"):
        bind(host, 0)


def test_ipv6_loopback_works_where_the_machine_has_it() -> None:
    try:
        listener = bind("::1", 0)
    except InvalidValueError as error:
        assert error.key == "--host"
        pytest.skip("this machine has no IPv6")
    with listener:
        assert listener.family == socket.AF_INET6
        assert listener.getsockname()[0] == "::1"
