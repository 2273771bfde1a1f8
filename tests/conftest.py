"""What every test may use."""

import os
import secrets
import signal
import time

import pytest

# Ray reads these when it is imported, which collecting its tests does.
os.environ.setdefault("RAY_AUTH_MODE", "token")
os.environ.setdefault("RAY_AUTH_TOKEN", secrets.token_hex(32))

# A shell lets what it starts in the background ignore Ctrl-C, which our child processes inherit.
signal.signal(signal.SIGINT, signal.default_int_handler)

_LOOP = 300_000
_LOOP_ON_A_CALM_MACHINE_S = 0.02


@pytest.fixture
def pace() -> float:
    """How much slower than a calm machine this one is right now, at least 1.

    Bounds on times are multiplied with it, so that a busy machine fails no test.
    """
    begin = time.perf_counter()
    count = 0
    while count < _LOOP:
        count += 1
    return max(1.0, (time.perf_counter() - begin) / _LOOP_ON_A_CALM_MACHINE_S)
