"""A browser window on the laboratory, as its person uses it."""

import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from playwright.sync_api import BrowserContext, ConsoleMessage, Page

ARTIFACTS = Path(__file__).resolve().parents[3] / "test-artifacts"

VISERS_OWN_ERROR = "Unable to preventDefault inside passive event listener invocation."
"""viser 1.1.1 logs this whenever a node that can be dragged is pressed."""

PROJECT = """([x, y, z]) => {
    const m = window.__viserMutable, box = m.canvas.getBoundingClientRect();
    m.camera.updateMatrixWorld();
    const p = m.camera.position.clone().set(x, y, z);
    p.applyMatrix4(m.nodeRefFromName["/field"].parent.matrixWorld).project(m.camera);
    return [box.left + (p.x + 1) / 2 * box.width, box.top + (1 - p.y) / 2 * box.height];
}"""

NODE = """(name) => {
    const node = window.__viserMutable?.nodeRefFromName?.[name];
    return node && {
        position: node.position.toArray(),
        quaternion: node.quaternion.toArray(),
        visible: node.visible,
    };
}"""

IS_VISIBLE = """(name) => {
    const node = window.__viserSceneTree?.getState()[name];
    return node !== undefined && (node.overrideVisibility ?? node.visibility ?? true);
}"""

RECORD_PUSHER = """() => {
    const track = window.__track = [];
    const look = () => {
        if (track !== window.__track) return;
        const pusher = window.__viserMutable?.nodeRefFromName?.["/pusher"];
        if (pusher?.visible) track.push(pusher.position.toArray());
        requestAnimationFrame(look);
    };
    look();
}"""

IS_STEADY = """() => {
    const m = window.__viserMutable;
    if (!m?.nodeRefFromName?.["/blocks/0"]?.visible) return false;
    if (document.getElementById("first-look")) return false;
    const now = JSON.stringify([m.camera.position.toArray(), m.camera.aspect]);
    const before = window.__before;
    window.__before = now;
    return now === before && m.canvas.getBoundingClientRect().width < 680;
}"""


class LabPage:
    """One browser window on the laboratory, in the words of the person who uses it."""

    def __init__(self, context: BrowserContext, url: str) -> None:
        self._context = context
        self.page: Page = context.new_page()
        self.url = url
        self.errors: list[str] = []
        self.page.on("console", self._note)
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("response", self._note_failure)

    def open(self) -> "LabPage":
        self.page.goto(self.url)
        self.wait_ready()
        return self

    def close(self) -> None:
        self._context.close()

    def reload(self) -> None:
        self.page.reload()
        self.wait_ready()

    def wait_ready(self) -> None:
        """Until the blocks are there, the camera has come to rest and the toast is gone."""
        self.page.wait_for_function(IS_STEADY, timeout=60_000, polling=300)
        toast = self.page.locator(".mantine-Notification-closeButton")
        for _ in range(toast.count()):
            toast.first.click()

    def node(self, name: str) -> dict[str, Any] | None:
        found: dict[str, Any] | None = self.page.evaluate(NODE, name)
        return found

    def position(self, name: str) -> tuple[float, float, float]:
        node = self.node(name)
        assert node is not None, f"there is no {name}"
        x, y, z = node["position"]
        return x, y, z

    @property
    def is_pushing(self) -> bool:
        """Whether the pusher is drawn."""
        return self.is_visible("/pusher")

    def is_visible(self, name: str) -> bool:
        """Whether a node is drawn."""
        return bool(self.page.evaluate(IS_VISIBLE, name))

    @property
    def camera(self) -> list[float]:
        place: list[float] = self.page.evaluate(
            "() => window.__viserMutable.camera.position.toArray()"
        )
        return place

    def look_from_top(self) -> None:
        """Press C and wait until the camera is there."""
        self.press("c")
        self.wait(lambda: abs(self.width_at(1.0) - self.width_at(-1.0)) < 3)

    def width_at(self, y: float) -> float:
        """Width of the workspace in the picture, at some y [pixels]."""
        return self.on_screen(1.0, y)[0] - self.on_screen(-1.0, y)[0]

    def on_screen(self, x: float, y: float, z: float = 0.0) -> tuple[float, float]:
        px, py = self.page.evaluate(PROJECT, [x, y, z])
        return px, py

    def click_table(self, x: float, y: float) -> None:
        self.page.mouse.click(*self.on_screen(x, y))

    def drag_table(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        mouse = self.page.mouse
        mouse.move(*self.on_screen(*start))
        mouse.down()
        mouse.move(*self.on_screen((start[0] + end[0]) / 2, (start[1] + end[1]) / 2), steps=4)
        mouse.move(*self.on_screen(*end), steps=4)
        self.page.wait_for_timeout(200)
        mouse.up()

    def grab_block(self, index: int) -> None:
        """Press the mouse button on the top of a block."""
        x, y, z = self.position(f"/blocks/{index}")
        self.page.mouse.move(*self.on_screen(x, y, 2 * z))
        self.page.mouse.down()

    def drag_block(self, index: int, x: float, y: float) -> None:
        """Move the mouse so that a grabbed block comes to a place; wait until it is drawn there."""
        name = f"/blocks/{index}"
        self.page.mouse.move(*self.on_screen(x, y, 2 * self.position(name)[2]), steps=4)
        self.wait(lambda: math.dist(self.position(name)[:2], (x, y)) < 0.01)

    def record_pusher(self) -> None:
        """From now on, keep the places at which the pusher is drawn."""
        self.page.evaluate(RECORD_PUSHER)

    @property
    def track(self) -> list[list[float]]:
        places: list[list[float]] = self.page.evaluate("() => window.__track")
        return places

    def wait(self, is_true: Callable[[], object], timeout_s: float = 30.0) -> None:
        deadline = time.monotonic() + timeout_s
        while not is_true():
            assert time.monotonic() < deadline, f"did not happen; the page says: {self.text}"
            self.page.wait_for_timeout(50)

    def wait_for_text(self, text: str, timeout_s: float = 30.0) -> None:
        self.wait(lambda: text in self.text, timeout_s)

    @property
    def text(self) -> str:
        return self.page.inner_text("body")

    def press(self, key: str) -> None:
        """Press a key with the table in focus, as after a click on it."""
        self.page.evaluate("() => document.activeElement?.blur()")
        self.page.keyboard.press(key)

    def button(self, name: str) -> Any:
        return self.page.get_by_role("button", name=name, exact=True).first

    def tab(self, name: str) -> None:
        self.page.get_by_role("tab", name=name, exact=True).first.click()

    def picture(self, name: str) -> bytes:
        ARTIFACTS.mkdir(exist_ok=True)
        return self.page.screenshot(path=ARTIFACTS / f"{name}.png", timeout=60_000)

    def _note(self, message: ConsoleMessage) -> None:
        if message.type == "error" and message.text != VISERS_OWN_ERROR:
            self.errors.append(message.text)

    def _note_failure(self, response: Any) -> None:
        if response.status >= 400:
            self.errors.append(f"{response.status} {response.url}")
