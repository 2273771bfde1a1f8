"""The page: how soon it answers, how fast its fields follow, and what it costs a training."""

import math
import os
import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from singulate.bench.dashboard_drag import drag_block
from singulate.bench.dashboard_opening import time_opening
from singulate.bench.dashboard_page import VIEWPORT, ClickTimes, open_page
from singulate.bench.dashboard_process import (
    SCENARIO,
    running_bare_page,
    running_dashboard,
    running_trainer,
)
from singulate.bench.dashboard_socket import open_socket
from singulate.bench.measurement import BenchOptions, Measurement
from singulate.exceptions import SingulateError

if TYPE_CHECKING:
    from singulate.bench.dashboard_tax import Tax

NUM_CLICKS = 20
_FREE_PLACES = ((-0.8, -0.7), (0.8, -0.7), (-0.6, -0.8), (0.6, -0.8))
"""Starts on ``fixed-2`` from which a push upwards meets nothing [m]."""
_DRAG_PLACES = ((-0.5, 0.4), (0.5, 0.5), (0.5, -0.4), (-0.5, -0.3))
"""Where a block of ``random-3`` is dragged to [m]."""
_STANDING_BACK = 19
"""Niceness that comes close to a browser on another machine."""
_PAIRS_PER_REPEAT = 8
"""Single phases of a training differ by a tenth: a loss of 3 % shows in the median of many."""


def bench_dashboard(options: BenchOptions) -> Iterator[Measurement]:
    """Drive the real page in headless Chromium and over bare websockets.

    Raises:
        SingulateError: If playwright, psutil or a browser is missing, or the page does not answer.
    """
    try:
        from singulate.bench.dashboard_clients import bench_clients
    except ImportError:
        raise SingulateError(
            "bench dashboard needs psutil: pip install 'singulate[test]'"
        ) from None
    with tempfile.TemporaryDirectory(prefix="singulate-bench-") as temporary:
        directory = Path(temporary)
        yield from _opening(directory, options.num_repeats)
        yield from _dragging(directory, options.num_repeats)
        yield from bench_clients(directory, options.seconds)
        yield from _beside_training(directory, options)


def _opening(directory: Path, num_repeats: int) -> Iterator[Measurement]:
    with (
        running_dashboard(directory, scenario="random-2") as dashboard,
        running_bare_page(directory) as bare_url,
    ):
        first = time_opening(dashboard.url, directory)
        by_turns = [
            (time_opening(dashboard.url, directory), time_opening(bare_url, directory))
            for _ in range(num_repeats)
        ]
    later, bare = [ours for ours, _ in by_turns], [theirs.drawn for _, theirs in by_turns]
    note = "a new browser each time, software rendering"
    looked, drawn = f"pictures of scene and maps; {note}", f"live scene and true reward; {note}"
    yield Measurement("opening: first look, first visitor", 1e3 * first.first_look, "ms", looked)
    yield from _spread("opening: first look", [each.first_look for each in later], looked)
    yield Measurement("opening: live, first visitor", 1e3 * first.drawn, "ms", drawn)
    yield from _spread("opening: live", [each.drawn for each in later], drawn)
    yield from _spread("opening: a bare page of viser", bare, f"a block on a square; {note}")
    ratio = float(np.median([each.drawn for each in later]) / np.median(bare))
    yield Measurement("opening: live against a bare page", ratio, "", "medians, by turns")


def _dragging(directory: Path, num_repeats: int) -> Iterator[Measurement]:
    with (
        running_dashboard(directory, scenario="random-3") as dashboard,
        open_page(dashboard.url, directory) as page,
    ):
        page.wait_for_reward_map()
        pauses = [pause for _ in range(num_repeats) for pause in drag_block(page, _DRAG_PLACES)]
    note = f"{len(pauses)} pauses of a drag on random-3, browser on the same machine"
    yield from _spread("pause to coarse true reward", [pause.coarse_s for pause in pauses], note)
    yield from _spread("pause to full true reward", [pause.full_s for pause in pauses], note)
    for name, values in (
        ("places of a dragged block", [pause.poses_per_second for pause in pauses]),
        ("pictures while dragging", [pause.pictures_per_second for pause in pauses]),
    ):
        yield Measurement(name, float(np.median(values)), "1/s", f"{note}, software rendering")


def _beside_training(directory: Path, options: BenchOptions) -> Iterator[Measurement]:
    from singulate.bench.dashboard_tax import measure_tax, tree

    run_dir = directory / "run"
    num_pairs = _PAIRS_PER_REPEAT * options.num_repeats
    with running_trainer(run_dir), running_dashboard(directory, run_dir) as dashboard:
        with open_socket(dashboard.url) as socket:
            undrawn = [socket.click(*_place(i)) for i in range(NUM_CLICKS)]
            trained_bytes = socket.num_bytes(options.seconds) / options.seconds
        note = f"{NUM_CLICKS} clicks over the page's websocket, an agent trains, nothing is drawn"
        yield from _spread("click to motion at the server", undrawn, note)
        with open_page(dashboard.url, directory) as page:
            page.wait_for_reward_map()
            clicks = [page.click(*_place(i)) for i in range(NUM_CLICKS)]
            picture_rate = page.pictures_per_second(2.0)
        yield from _clicks(clicks, picture_rate)
        yield Measurement(
            "bytes to a client beside training", trained_bytes, "B/s", "curves, starts"
        )
        with open_page(dashboard.url, directory, niceness=_STANDING_BACK) as page:
            page.press("Reset")
            page.wait_for_reward_map()

            def taxed(act: Callable[[], None] = lambda: None) -> "Tax":
                browser = [each for each in tree(os.getpid()) if "chrom" in each.name()]
                processes = [*tree(dashboard.pid), *browser]
                seconds = options.seconds / 2.0
                return measure_tax(run_dir, processes, seconds, num_pairs, act)

            yield _tax("page open, idle", taxed(), num_pairs)
            all_anew = taxed(lambda: page.press("Next seed"))
            yield _tax("page open, all fields anew", all_anew, num_pairs)


def _tax(name: str, tax: "Tax", num_pairs: int) -> Measurement:
    first, third = tax.quartiles
    return Measurement(
        f"training speed kept, {name}", tax.speed_kept, "",
        f"DQN on {SCENARIO}, exploring; pushes/s with the page at work against stopped, by "
        f"turns: median of {num_pairs} pairs, half of them from {first:.2f} to {third:.2f}",
    )  # fmt: skip


def _place(index: int) -> tuple[float, float]:
    return _FREE_PLACES[index % len(_FREE_PLACES)]


def _clicks(clicks: Sequence[ClickTimes], picture_rate: float) -> Iterator[Measurement]:
    note = (
        f"{len(clicks)} clicks, from the release of the button, an agent trains, software rendering"
    )
    yield from _spread("click to motion in the browser", [each.motion for each in clicks], note)
    yield from _spread("click to picture", [each.picture for each in clicks], note)
    size = f"{VIEWPORT[0]} x {VIEWPORT[1]}"
    yield Measurement("whole pictures", picture_rate, "1/s", f"{size}, software rendering")


def _spread(name: str, seconds: Sequence[float], note: str) -> Iterator[Measurement]:
    for which, value in (("median", float(np.median(seconds))), ("max", max(seconds))):
        if math.isfinite(value):
            yield Measurement(f"{name}, {which}", 1e3 * value, "ms", note)
        else:
            yield Measurement(f"{name}, {which}", None, "ms", f"not in time; {note}")
