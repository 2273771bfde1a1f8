"""A block dragged in the browser: when the true reward of its new place is on the table."""

import math
import time
from collections.abc import Sequence
from typing import NamedTuple, TypedDict

from singulate.bench.dashboard_page import PROJECT, DashboardPage

PAUSE_S = 4.0
SWEEP_S = 1.0
"""How long the pointer is on its way to the next place."""
_BLOCK = "/blocks/0"
_FINEST = 64

_WATCH = r"""() => {
    const log = (window.__dragLog = {moved: 0, fields: [], poses: [], drawn: []});
    let fresh = 0;
    const queue = window.__viserMutable.messageQueue;
    const push = queue.push;
    queue.push = function (...messages) {
        const now = performance.now();
        let isNews = false;
        for (const message of messages) {
            const legend = /True reward.*?(\d+) \u00d7 \d+([^<]*)/.exec(message.updates?.content);
            if (legend?.[2].includes("earlier")) fresh = 0;
            else if (legend) fresh = legend[2].includes("%") ? 1 : Number(legend[1]);
            isNews ||= legend || message.name === "/field";
            if (message.name === "BLOCK" && message.type === "SetPositionMessage") {
                log.poses.push(now);
            }
        }
        if (isNews) log.fields.push([now, fresh]);
        return push.apply(this, messages);
    };
    const context = window.__viserMutable.canvas.getContext("webgl2");
    const draw = context.drawElements;
    let isDrawn = false;
    context.drawElements = (...call) => { isDrawn = true; draw.apply(context, call); };
    const look = () => {
        if (isDrawn) log.drawn.push(performance.now());
        isDrawn = false;
        requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
}""".replace("BLOCK", _BLOCK)
"""The legend of a true reward tells its fineness, and whether it is of an earlier table. It arrives
with the picture, or alone where the picture of the new place is the one that is there. A page
draws nothing in a frame in which nothing has changed; only frames in which it does are counted."""

_SWEEP = """([begin, end, seconds]) => new Promise((resolve) => {
    const log = window.__dragLog;
    Object.assign(log, {fields: [], poses: [], drawn: []});
    const start = performance.now();
    const timer = setInterval(() => {
        const share = Math.min(1, (performance.now() - start) / (1000 * seconds));
        const [x, y] = [0, 1].map((i) => begin[i] + share * (end[i] - begin[i]));
        window.__viserMutable.canvas.dispatchEvent(new PointerEvent("pointermove", {
            clientX: x, clientY: y, pointerId: 1, pointerType: "mouse", buttons: 1, bubbles: true,
        }));
        if (share < 1) return;
        clearInterval(timer);
        log.moved = performance.now();
        resolve();
    }, 1000 / 60);
})"""
"""Moves at the rate of a mouse; each movement from outside the browser would wait for a frame."""


class DragPause(NamedTuple):
    """What was seen of one pause of a drag and of the way to it.

    Attributes:
        coarse_s: From the last movement until a true reward of the new place has come [s].
        full_s: Until it was complete [s]; infinite where it was not before the next movement.
        poses_per_second: Places of the block that came while it moved.
        pictures_per_second: Pictures that the page drew meanwhile.
    """

    coarse_s: float
    full_s: float
    poses_per_second: float
    pictures_per_second: float


class _Log(TypedDict):
    moved: float
    fields: list[tuple[float, int]]
    poses: list[float]
    drawn: list[float]


def drag_block(page: DashboardPage, places: Sequence[tuple[float, float]]) -> list[DragPause]:
    """Drag the first block from place to place on the table, with a pause at each.

    Args:
        page: The open dashboard, with the true reward on the table.
        places: Where to, (x, y) [m].
    """
    window = page.window
    x, y, z = window.evaluate(
        "(name) => window.__viserMutable.nodeRefFromName[name].position.toArray()", _BLOCK
    )
    here = window.evaluate(PROJECT, [x, y, 2 * z])
    window.evaluate(_WATCH)
    window.mouse.move(*here)
    window.mouse.down()
    pauses = []
    for place in places:
        there = window.evaluate(PROJECT, [*place, 2 * z])
        window.evaluate(_SWEEP, [here, there, SWEEP_S])
        time.sleep(PAUSE_S)
        pauses.append(_read(window.evaluate("() => window.__dragLog")))
        here = there
    window.mouse.move(*here)
    window.mouse.up()
    return pauses


def _read(log: _Log) -> DragPause:
    moved = log["moved"]
    # The movement before the last one may have its true reward only now.
    settled = max([moved, *log["poses"]])
    coarse = [at for at, fresh in log["fields"] if at > settled and fresh > 0]
    full = [at for at, fresh in log["fields"] if at > settled and fresh == _FINEST]
    return DragPause(
        (coarse[0] - moved) / 1e3 if coarse else math.inf,
        (full[0] - moved) / 1e3 if full else math.inf,
        sum(at <= moved for at in log["poses"]) / SWEEP_S,
        sum(at <= moved for at in log["drawn"]) / SWEEP_S,
    )
