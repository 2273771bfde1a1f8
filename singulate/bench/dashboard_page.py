"""The real page in headless Chromium: clicks on the table, and when the pusher answers."""

import shutil
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from singulate.exceptions import SingulateError

if TYPE_CHECKING:
    from playwright.sync_api import Page

VIEWPORT = (1280, 720)
_BROWSERS = ("chromium", "chromium-browser", "google-chrome")
_ARGUMENTS = (
    "--headless=new",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
    "--no-sandbox",
)
_TIMEOUT_MS = 60_000
_HOVER_MS = 500.0
"""How long the pointer rests before it clicks; people need about as long [ms]."""

_IS_READY = """() => {
    const nodes = window.__viserMutable?.nodeRefFromName;
    return nodes?.["/pusher"] && nodes["/field"] && nodes["/blocks/0"];
}"""

_WATCH = """() => {
    const times = (window.__clickTimes = {released: NaN, arrived: NaN, drawn: NaN});
    window.__fieldChangedAt = performance.now();
    addEventListener("pointerup", (event) => {
        Object.assign(times, {released: event.timeStamp, arrived: NaN, drawn: NaN});
    }, true);
    const queue = window.__viserMutable.messageQueue;
    const push = queue.push;
    queue.push = function (...messages) {
        const isMotion = (m) => m.name === "/pusher" && m.type === "SetPositionMessage";
        if (messages.some((m) => m.name === "/field")) {
            window.__fieldChangedAt = performance.now();
        }
        if (isNaN(times.arrived) && messages.some(isMotion)) {
            times.arrived = performance.now();
            requestAnimationFrame(() => requestAnimationFrame(() => {
                times.drawn = performance.now();
            }));
        }
        return push.apply(this, messages);
    };
}"""

PROJECT = """([x, y, z]) => {
    const {camera, canvas, nodeRefFromName} = window.__viserMutable;
    const apply = (e, v) => [0, 1, 2, 3].map(
        (i) => e[i] * v[0] + e[4 + i] * v[1] + e[8 + i] * v[2] + e[12 + i] * v[3]);
    const world = apply(nodeRefFromName[""].matrixWorld.elements, [x, y, z ?? 0, 1]);
    const eye = apply(camera.matrixWorldInverse.elements, world);
    const clip = apply(camera.projectionMatrix.elements, eye);
    const box = canvas.getBoundingClientRect();
    return [box.x + (clip[0] / clip[3] + 1) / 2 * box.width,
            box.y + (1 - clip[1] / clip[3]) / 2 * box.height];
}"""

_IS_AT_REST = """() => window.__viserMutable.nodeRefFromName["/pusher"].visible === false"""

_IS_MAP_COMPLETE = "(quiet_s) => performance.now() - window.__fieldChangedAt > 1e3 * quiet_s"
_QUIET_S = 5.0
"""A reward map under way changes the field on the table more often than this [s]."""

_HAS_MOVED = "() => !isNaN(window.__clickTimes.drawn)"

_PICTURES = """(seconds) => new Promise((resolve) => {
    const viewer = window.__viserMutable;
    const { gl } = viewer.scene.__r3f.root.getState();
    const begin = performance.now();
    let pictures = 0;
    const count = () => {
        const passed = (performance.now() - begin) / 1000;
        if (passed >= seconds) return resolve(pictures / passed);
        gl.drawWhole();
        viewer.requestRender();
        pictures += 1;
        requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
})"""


class ClickTimes(NamedTuple):
    """Seconds from the release of the mouse button, in the browser's own clock.

    A press alone does not push: it may become an arrow, or a turn of the camera.

    Attributes:
        motion: Until the pusher's motion has arrived in the page.
        picture: Until it has been drawn.
    """

    motion: float
    picture: float


@contextmanager
def open_page(url: str, directory: Path, niceness: int = 0) -> Iterator["DashboardPage"]:
    """Open the dashboard in a browser of its own and wait until the table is there.

    Args:
        url: Where the dashboard listens.
        directory: For a small file that starts the browser.
        niceness: How far the browser stands back; 19 comes close to a browser elsewhere.

    Raises:
        SingulateError: If playwright or a browser is missing, or the page does not answer.
    """
    with open_window(directory, niceness) as window:
        window.goto(url)
        window.wait_for_function(_IS_READY, timeout=_TIMEOUT_MS)
        window.evaluate(_WATCH)
        yield DashboardPage(window)


@contextmanager
def open_window(directory: Path, niceness: int = 0) -> Iterator["Page"]:
    """Start a browser that has seen no page yet; see `open_page`."""
    try:
        from playwright.sync_api import Error, sync_playwright
    except ImportError:
        raise SingulateError(
            "bench dashboard needs playwright: pip install 'singulate[test]'"
        ) from None
    width, height = VIEWPORT
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(
                executable_path=_nice_browser(directory, niceness), args=list(_ARGUMENTS)
            )
            yield browser.new_page(viewport={"width": width, "height": height})
            browser.close()
    except Error as error:
        raise SingulateError(f"the page does not answer: {str(error).splitlines()[0]}") from error


class DashboardPage:
    """A browser with the dashboard open; see `open_page`.

    Attributes:
        window: Playwright's page.
    """

    def __init__(self, window: "Page") -> None:
        self.window = window

    def click(self, x: float, y: float) -> ClickTimes:
        """Click on the table once it is at rest and wait until the pusher has been seen moving.

        The pointer is there a moment before the button goes down, as a hand's is: the aim arrow
        follows it, and drawing that is no part of the answer to the click.

        Args:
            x: Where, from left to right [m].
            y: Where, from below to above [m].
        """
        page = self.window
        page.wait_for_function(_IS_AT_REST, timeout=_TIMEOUT_MS)
        page.mouse.move(*page.evaluate(PROJECT, [x, y]))
        page.wait_for_timeout(_HOVER_MS)
        page.mouse.down()
        page.mouse.up()
        page.wait_for_function(_HAS_MOVED, timeout=_TIMEOUT_MS)
        times = page.evaluate("() => window.__clickTimes")
        released = times["released"]
        return ClickTimes(
            (times["arrived"] - released) / 1e3,
            (times["drawn"] - released) / 1e3,
        )

    def wait_for_reward_map(self) -> None:
        """Wait until the field on the table changes no more: its reward map is complete."""
        self.window.wait_for_function(_IS_MAP_COMPLETE, arg=_QUIET_S, timeout=2 * _TIMEOUT_MS)

    def press(self, button: str) -> None:
        """Press a button of the page."""
        self.window.get_by_role("button", name=button, exact=True).first.click()

    def pictures_per_second(self, seconds: float) -> float:
        """Pictures that the browser draws a second if each is drawn whole."""
        return float(self.window.evaluate(_PICTURES, seconds))


def _nice_browser(directory: Path, niceness: int) -> Path:
    executable = next(filter(None, map(shutil.which, _BROWSERS)), None)
    if executable is None:
        raise SingulateError(f"bench dashboard needs a browser: one of {', '.join(_BROWSERS)}")
    launcher = directory / f"browser-{niceness}"
    launcher.write_text(
        f"#!{sys.executable}\n"
        "import os, sys\n"
        "from singulate.engine.standing_back import stand_back\n"
        f"stand_back({niceness})\n"
        f"os.execv({executable!r}, [{executable!r}, *sys.argv[1:]])\n"
    )
    launcher.chmod(launcher.stat().st_mode | stat.S_IXUSR)
    return launcher
