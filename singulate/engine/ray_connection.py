"""Joining a Ray cluster, or starting one on this machine."""

import os
import secrets
import socket
import sys
from typing import Any

from singulate.engine.interface import EngineError
from singulate.exceptions import InvalidValueError

CONNECT_TIMEOUT_S = 5.0
LOCAL = "local"

_QUIET = {"RAY_USAGE_STATS_ENABLED": "0", "RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO": "0"}
"""No report to Ray's makers, and no warning about accelerators that nobody uses."""


def connect(address: str | None, num_cpus: int | None) -> bool:
    """Connect this process to Ray, unless it is connected already.

    Without an address, Ray is started on this machine. Its ports are open to the network, so it
    asks for a token that is drawn here, unless the environment already says what it asks for. Ray
    looks at the environment only once, while it is imported.

    Args:
        address: ``HOST:PORT`` of a cluster's head, ``auto`` for the one that runs on this machine.
        num_cpus: Cores of a Ray that is started; all by default.

    Returns:
        Whether it was connected now, so that `disconnect` is due.

    Raises:
        InvalidValueError: If the address is not one, or nothing listens there.
        EngineError: If Ray is not installed or refuses.
    """
    if address is None:
        _ask_for_a_token()
    else:
        _check_reachable(address)
    for name, value in _QUIET.items():
        os.environ.setdefault(name, value)
    import ray

    if ray.is_initialized():
        return False
    quiet: dict[str, Any] = {"log_to_driver": False, "logging_level": "ERROR"}
    try:
        if address is None:
            ray.init(LOCAL, num_cpus=num_cpus, include_dashboard=False, **quiet)
        else:
            ray.init(address, **quiet)
    except (ray.exceptions.RayError, ConnectionError, RuntimeError, ValueError) as error:
        first = str(error).strip().splitlines()[0]
        if address is None:
            raise EngineError(f"Ray does not start on this machine: {first}") from None
        hint = "is its token in RAY_AUTH_TOKEN, and RAY_AUTH_MODE=token?"
        raise EngineError(f"no Ray answers at {address}: {first}; {hint}") from None
    return True


def disconnect() -> None:
    """Leave the cluster; a Ray that `connect` started ends."""
    import ray

    ray.shutdown()


def count_cores() -> int:
    """Cores of the cluster."""
    import ray

    resources: dict[str, float] = ray.cluster_resources()  # type: ignore[no-untyped-call]
    return int(resources.get("CPU", 1))


def _ask_for_a_token() -> None:
    if "RAY_AUTH_MODE" in os.environ:
        return
    if "ray" in sys.modules:
        if sys.modules["ray"].is_initialized():
            return
        raise EngineError("Ray was imported before RAY_AUTH_MODE=token was set in the environment")
    os.environ["RAY_AUTH_MODE"] = "token"
    if not {"RAY_AUTH_TOKEN", "RAY_AUTH_TOKEN_PATH"} & set(os.environ):
        os.environ["RAY_AUTH_TOKEN"] = secrets.token_hex(32)


def _check_reachable(address: str) -> None:
    """Ray itself takes minutes to find out, and then ends the process."""
    allowed = "HOST:PORT of a Ray cluster's head, or auto"
    if address == "auto":
        return
    host, _, port = address.rpartition(":")
    if not host or "/" in host or not port.isdecimal() or not 0 < int(port) < 2**16:
        raise InvalidValueError("address", address, allowed)
    try:
        socket.create_connection((host, int(port)), CONNECT_TIMEOUT_S).close()
    except OSError as error:
        reason = f"{allowed} that can be reached ({error.strerror or error})"
        raise InvalidValueError("address", address, reason) from None
