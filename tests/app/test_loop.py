"""How often the main loop works."""

import threading

import pytest

from app.laboratory import Laboratory
from app.loop import CALM_AFTER_S, Dashboard
from app.security import AccessPolicy
from app.server import bind, open_server

WATCHED_S = 2.0


class CountingLaboratory(Laboratory):
    num_ticks = 0

    def tick(self):
        self.num_ticks += 1
        return super().tick()


@pytest.fixture
def laboratory(tmp_path):
    laboratory = CountingLaboratory(runs_dir=tmp_path, checkpoints_dir=tmp_path, num_workers=1)
    yield laboratory
    laboratory.close()


def test_a_calm_page_is_seldom_looked_after(laboratory):
    listener = bind("127.0.0.1", 0)
    server = open_server(listener, AccessPolicy("127.0.0.1", listener.getsockname()[1], None))
    dashboard = Dashboard(server, laboratory)
    while laboratory.tick().scene is None:
        laboratory.wait(0.1)
    before = laboratory.num_ticks
    stop = threading.Event()
    threading.Timer(CALM_AFTER_S + WATCHED_S, stop.set).start()
    dashboard.run(stop)
    num_ticks = laboratory.num_ticks - before
    # On a busy machine the rounds are rarer, but nothing may be left to itself.
    assert WATCHED_S < num_ticks <= 30 * CALM_AFTER_S + 4 * WATCHED_S + 4
    server.stop()
