"""A browser that stops reading is let go; the others are not kept waiting."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

Eventually = Callable[[Callable[[], object]], None]


def test_a_browser_that_takes_nothing_is_dropped(
    door: Any, eventually: Eventually, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.security.connection.SEND_TIMEOUT_S", 0.5)
    door.enter()
    reading = door.enter()
    stalled_id, reading_id = sorted(door.server.get_clients())
    noise = np.random.default_rng(0).integers(0, 256, (1000, 1000, 3), dtype=np.uint8)
    picture = door.server.scene.add_image("/picture", noise, 1.0, 1.0, format="png")

    def is_dropped() -> bool:
        picture.image = noise = np.roll(picture.image, 1, axis=0)
        for _ in range(20):
            if len(reading.recv(timeout=10)) > noise.size // 2:
                break
        return stalled_id not in door.server.get_clients()

    eventually(is_dropped)
    assert reading_id in door.server.get_clients()
