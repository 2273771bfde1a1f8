"""``python -m app.bare_page``: the least that a page of viser can be.

It is what opening the dashboard is compared with, see ``singulate bench dashboard``.
"""

import signal
import sys
import threading

import numpy as np
import viser

from app.security import AccessPolicy
from app.server import bind, open_server
from app.views.light import add_lights

_HOST = "127.0.0.1"


def main() -> int:
    """Serve a block on a square, of plain colours, until interrupted."""
    listener = bind(_HOST, 0)
    policy = AccessPolicy(_HOST, listener.getsockname()[1], None)
    server = open_server(listener, policy)
    _draw(server.scene)
    stop = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.set())
    print(f"singulate: open {policy.url}", flush=True)
    stop.wait()
    server.stop()
    return 0


def _draw(scene: viser.SceneApi) -> None:
    add_lights(scene)
    scene.add_image("/field", np.full((64, 64, 3), 100, np.uint8), 2.0, 2.0)
    scene.add_box("/blocks/0", (200, 120, 40), (0.2, 0.2, 0.2))


if __name__ == "__main__":
    sys.exit(main())
