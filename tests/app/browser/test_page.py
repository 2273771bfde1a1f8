"""The page loads, and every view is really drawn."""

import io
import math
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from PIL import Image
from playwright.sync_api import Browser

from app.fields.catalogue import FIELD_KINDS, FIELDS_BY_KEY, FIELDS_BY_LABEL
from app.views.table import MARGIN
from singulate.geometry import Workspace

REACH = Workspace().half_length + MARGIN

pytestmark = pytest.mark.browser

FIELD_PIXELS = """() => {
    let found = null;
    window.__viserMutable.nodeRefFromName["/field"].traverse((o) => {
        const image = o.material?.map?.image;
        if (!image) return;
        const canvas = new OffscreenCanvas(64, 64);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0, 64, 64);
        found = Array.from(context.getImageData(0, 0, 64, 64).data);
    });
    return found;
}"""


def pixels(png: bytes) -> npt.NDArray[np.uint8]:
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"))


def field_pixels(page: Any) -> npt.NDArray[np.uint8]:
    data = page.page.evaluate(FIELD_PIXELS)
    assert data is not None, "no picture lies on the table"
    return np.array(data, dtype=np.uint8).reshape(64, 64, 4)


def shown_field(page: Any) -> str:
    """Name of the field in the open tab's form."""
    values = page.page.evaluate(
        "() => [...document.querySelectorAll('input')]"
        ".filter((input) => input.offsetParent).map((input) => input.value)"
    )
    return next((value for value in values if value in FIELDS_BY_LABEL), "")


WATCH_FIRST_LOOK = """(() => {
    const isLive = (name) => window.__viserMutable?.nodeRefFromName?.[name] !== undefined;
    const look = () => {
        const hasAll = document.querySelector("#first-look script") !== null;
        const images = [...document.querySelectorAll("#first-look img")];
        if (hasAll && images.every((each) => each.complete)) {
            const widths = images.map((each) => each.getBoundingClientRect().width);
            window.__shown ??= [widths, isLive("/blocks/0")];
        }
        if (window.__shown && !document.getElementById("first-look")) {
            window.__gone = ["/field", "/blocks/0"].map(isLive);
        } else {
            requestAnimationFrame(look);
        }
    };
    requestAnimationFrame(look);
})()"""


def show_field(page: Any, label: str) -> None:
    """Turn fields over until one lies on the table."""
    page.wait(lambda: shown_field(page))
    for _ in FIELD_KINDS:
        before = shown_field(page)
        if before == label:
            return
        page.press("f")
        page.wait(lambda before=before: shown_field(page) not in ("", before), 10)
    assert shown_field(page) == label


def test_webgl_draws_the_table_between_the_panels(page: Any) -> None:
    kind = page.page.evaluate("() => window.__viserMutable.canvas.getContext('webgl2') !== null")
    assert kind is True
    for name in ("/table/rim/0", "/table/edges", "/shadows/0", "/field", "/pusher"):
        assert page.node(name) is not None, name
    assert page.page.evaluate("() => window.__viserTestpoints.rendererInfo.memory.textures") >= 3

    left, bottom = page.on_screen(-REACH, -REACH)
    right = page.on_screen(REACH, -REACH)[0]
    top = page.on_screen(REACH, REACH)[1]
    assert 260 <= left < right <= 1280 - 356
    assert 0 <= top < bottom <= 720
    assert right - left > 500
    page.wait(lambda: pixels(page.picture("light"))[:, 300:900].std() > 20)


def test_pictures_of_the_scene_are_there_before_viser_and_give_way_to_it(
    browser: Browser, app_url: str
) -> None:
    context = browser.new_context(viewport={"width": 1280, "height": 720})
    page = context.new_page()
    page.add_init_script(WATCH_FIRST_LOOK)
    page.goto(app_url, wait_until="commit")
    page.wait_for_function("() => window.__gone !== undefined", timeout=60_000)
    shown, gone = page.evaluate("() => [window.__shown, window.__gone]")
    widths, is_live = shown
    assert len(widths) >= 3 and min(widths) >= 200, "scene, distance map and the agent's map"
    assert not is_live, "it came before the live table"
    assert gone == [True, True], "the live table and its blocks were there when it went"
    context.close()


def test_the_persons_own_browser_was_asked_to_open_it(
    page: Any, app_url: str, opened: Path
) -> None:
    page.wait(opened.exists)
    page.wait(opened.read_text)
    assert opened.read_text() == app_url


def test_both_blocks_are_seen_in_colour(page: Any) -> None:
    colours = pixels(page.picture("blocks")).astype(int)
    for index in (0, 1):
        x, y, z = page.position(f"/blocks/{index}")
        column, row = page.on_screen(x, y, 2 * z)
        seen = colours[round(row), round(column)]
        assert seen.max() - seen.min() > 40, "a block is not coloured"


def test_every_field_lies_on_the_table_in_turn(page: Any) -> None:
    page.tab("Fields")
    keys = ("distance_map", "mask", "camera", "reward", "q", "error")
    drawn: set[bytes] = set()
    for key in keys:
        show_field(page, FIELDS_BY_KEY[key].label)
        page.wait(lambda: field_pixels(page)[..., :3].std() > 2, 20)
        page.wait(lambda: field_pixels(page).tobytes() not in drawn, 20)
        drawn.add(field_pixels(page).tobytes())
        page.picture(f"field-{key}")
    assert len(drawn) == len(keys)
    page.tab("Interact")


def test_the_field_is_the_right_way_up(page: Any) -> None:
    """The distance map is brightest in the corner that is furthest from the blocks."""
    corners = [(x, y) for x in (-0.9, 0.9) for y in (-0.9, 0.9)]
    blocks = [page.position(f"/blocks/{index}")[:2] for index in (0, 1)]
    distances = [min(math.dist(corner, block) for block in blocks) for corner in corners]

    page.tab("Fields")
    show_field(page, FIELDS_BY_KEY["distance_map"].label)
    page.wait(lambda: field_pixels(page)[..., :3].std() > 2, 20)
    page.page.wait_for_timeout(500)
    colours = pixels(page.picture("distance")).astype(int)
    places = [page.on_screen(*corner) for corner in corners]
    brightness = [colours[round(row), round(column)].sum() for column, row in places]
    assert np.argmax(brightness) == np.argmax(distances)
    assert np.argmin(brightness) == np.argmin(distances)
    page.tab("Interact")


def test_dark_and_light_are_both_drawn(page: Any) -> None:
    assert pixels(page.picture("light")).mean() > 140
    page.page.get_by_role("button", name="dark").first.click()
    page.wait(lambda: pixels(page.picture("dark")).mean() < 110)
    page.page.get_by_role("button", name="light").first.click()
    page.wait(lambda: pixels(page.picture("light")).mean() > 140)


def test_a_first_visit_has_the_theme_of_its_system_until_another_is_chosen(
    open_page: Callable[..., Any],
) -> None:
    visitor = open_page(prefers="dark")
    visitor.wait(lambda: pixels(visitor.picture("first-visit")).mean() < 110)
    visitor.page.get_by_role("button", name="light").first.click()
    visitor.wait(lambda: pixels(visitor.picture("first-visit")).mean() > 140)
    visitor.reload()
    assert pixels(visitor.picture("first-visit")).mean() > 140
    assert visitor.errors == []
    visitor.close()


def test_c_looks_from_straight_above(page: Any) -> None:
    page.look_from_top()
    assert page.width_at(1.0) > 500
    page.picture("top")


def test_the_pages_process_holds_neither_physics_nor_learning(
    page: Any, app_process: subprocess.Popen[str]
) -> None:
    maps = Path(f"/proc/{app_process.pid}/maps").read_text()
    assert "msgspec" in maps
    assert "pybullet" not in maps
    assert "libtorch" not in maps


def test_reload_keeps_working(page: Any) -> None:
    told = "up from (-0.60, 0.40)"
    assert told not in page.text
    page.reload()
    page.press("1")
    page.click_table(-0.6, 0.4)
    page.wait_for_text(told)


def test_two_browsers_see_one_table(page: Any, open_page: Callable[[], Any]) -> None:
    other = open_page()
    page.press("Space")
    page.press("2")
    page.click_table(-0.7, 0.3)
    page.press("n")
    for window in (page, other):
        window.wait(lambda window=window: window.is_pushing)
    other.wait(lambda: other.is_visible("/actor_name"))
    assert not page.is_visible("/actor_name")
    assert page.position("/pusher") == pytest.approx(other.position("/pusher"), abs=1e-6)
    other.press("Space")
    for window in (page, other):
        window.wait(lambda window=window: not window.is_pushing)
        window.wait_for_text("right from (-0.70, 0.30)")
    for index in (0, 1):
        assert page.position(f"/blocks/{index}") == other.position(f"/blocks/{index}")

    page.grab_block(0)
    page.drag_block(0, -0.5, -0.5)
    other.wait(lambda: other.is_visible("/actor_name"))
    other.wait_for_text("moving a block")
    assert not page.is_visible("/actor_name")
    assert other.position("/blocks/0") == pytest.approx(page.position("/blocks/0"), abs=1e-6)
    page.page.mouse.up()
    other.wait(lambda: not other.is_visible("/actor_name"))
    assert other.errors == []
    other.close()
