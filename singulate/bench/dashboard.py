"""The page while an agent trains: how soon a click moves the pusher, what the page costs."""

import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from singulate.bench.dashboard_page import VIEWPORT, ClickTimes, open_page
from singulate.bench.dashboard_process import (
    SCENARIO,
    pushes_per_second,
    running_dashboard,
    running_trainer,
)
from singulate.bench.dashboard_socket import open_socket
from singulate.bench.measurement import BenchOptions, Measurement

NUM_CLICKS = 20
_FREE_PLACES = ((-0.8, -0.7), (0.8, -0.7), (-0.6, -0.8), (0.6, -0.8))
"""Starts on ``fixed-2`` from which a push upwards meets nothing [m]."""


def bench_dashboard(options: BenchOptions) -> Iterator[Measurement]:
    """Drive the real page in headless Chromium while a DQN trains.

    The training's speed without the page is measured before and after, so that a machine that
    becomes slower or faster meanwhile is not counted for or against the page.
    """
    seconds = 2.0 * options.seconds
    with tempfile.TemporaryDirectory(prefix="singulate-bench-") as temporary:
        directory = Path(temporary)
        run_dir = directory / "run"
        with running_trainer(run_dir):
            alone = [pushes_per_second(run_dir, seconds)]
            with running_dashboard(directory, run_dir) as url:
                with open_socket(url) as socket:
                    undrawn = [socket.click(*_place(i)) for i in range(NUM_CLICKS)]
                with open_page(url, directory, niceness=19) as page:
                    page.wait_for_reward_map()
                    remote = pushes_per_second(run_dir, seconds)
                with open_page(url, directory) as page:
                    page.wait_for_reward_map()
                    local = pushes_per_second(run_dir, seconds)
                    clicks = [page.click(*_place(i)) for i in range(NUM_CLICKS)]
                    frame_rate = page.frames_per_second(2.0)
            alone.append(pushes_per_second(run_dir, seconds))
    yield from _undrawn_clicks(undrawn)
    yield from _clicks(clicks, frame_rate)
    yield from _rates(alone, remote, local)


def _place(index: int) -> tuple[float, float]:
    return _FREE_PLACES[index % len(_FREE_PLACES)]


def _undrawn_clicks(seconds: Sequence[float]) -> Iterator[Measurement]:
    note = f"{len(seconds)} clicks over the page's websocket, an agent trains, nothing is drawn"
    motion = 1e3 * np.array(seconds)
    yield Measurement("click to motion at the server, median", float(np.median(motion)), "ms", note)
    yield Measurement("click to motion at the server, max", float(motion.max()), "ms", note)


def _clicks(clicks: Sequence[ClickTimes], frame_rate: float) -> Iterator[Measurement]:
    note = f"{len(clicks)} clicks, an agent trains, software rendering"
    motion = 1e3 * np.array([click.motion for click in clicks])
    picture = 1e3 * np.array([click.picture for click in clicks])
    yield Measurement(
        "click to motion in the browser, median", float(np.median(motion)), "ms", note
    )
    yield Measurement("click to motion in the browser, max", float(motion.max()), "ms", note)
    yield Measurement("click to picture, median", float(np.median(picture)), "ms", note)
    size = f"{VIEWPORT[0]} x {VIEWPORT[1]}"
    yield Measurement("frames of the page", frame_rate, "1/s", f"{size}, software rendering")


def _rates(alone: Sequence[float], remote: float, local: float) -> Iterator[Measurement]:
    baseline = float(np.mean(alone))
    training = f"DQN on {SCENARIO}, exploring"
    each = ", ".join(f"{rate:.4g}" for rate in alone)
    yield Measurement("training alone", baseline, "pushes/s", f"{training}; before, after: {each}")
    yield Measurement("training, page open", remote, "pushes/s", "browser stands back (nice 19)")
    yield Measurement("training, page and browser", local, "pushes/s", "browser takes its share")
    yield Measurement("speed kept with the page open", remote / baseline, "", "1 is no loss")
    yield Measurement("speed kept with page and browser", local / baseline, "", "1 is no loss")
