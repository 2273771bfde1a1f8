"""How often the main loop works."""

import threading

import pytest

from app.laboratory import Laboratory
from app.loop import CALM_AFTER_S, SHORTEST_PERIOD_S, Dashboard
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


@pytest.fixture
def server():
    listener = bind("127.0.0.1", 0)
    server = open_server(listener, AccessPolicy("127.0.0.1", listener.getsockname()[1], None))
    yield server
    server.stop()


def run_for(seconds, dashboard):
    stop = threading.Event()
    threading.Timer(seconds, stop.set).start()
    dashboard.run(stop)


def test_a_calm_page_is_seldom_looked_after(server, laboratory):
    dashboard = Dashboard(server, laboratory)
    while laboratory.tick().scene is None:
        laboratory.wait(0.1)
    before = laboratory.num_ticks
    run_for(CALM_AFTER_S + WATCHED_S, dashboard)
    num_ticks = laboratory.num_ticks - before
    # On a busy machine the rounds are rarer, but nothing may be left to itself.
    assert WATCHED_S < num_ticks <= 30 * CALM_AFTER_S + 4 * WATCHED_S + 4


def test_what_arrives_between_two_pictures_is_passed_on_at_once(server, laboratory):
    pictures = []
    dashboard = Dashboard(server, laboratory, on_snapshot=pictures.append)
    done = threading.Event()

    def hurry():
        while not done.wait(0.002):
            laboratory.wake()

    news = threading.Thread(target=hurry)
    news.start()
    run_for(WATCHED_S, dashboard)
    done.set()
    news.join()
    assert 1 < len(pictures) <= WATCHED_S / SHORTEST_PERIOD_S + 1
    assert laboratory.num_ticks > len(pictures)
