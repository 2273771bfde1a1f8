"""The page loads, and every view is really drawn."""

import io
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from PIL import Image

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


def test_webgl_draws_the_table_between_the_panels(page: Any) -> None:
    kind = page.page.evaluate("() => window.__viserMutable.canvas.getContext('webgl2') !== null")
    assert kind is True
    for name in ("/table/top", "/table/marks", "/table/border", "/shadows", "/field", "/pusher"):
        assert page.node(name) is not None, name
    assert page.page.evaluate("() => window.__viserTestpoints.rendererInfo.memory.textures") >= 3

    left, top = page.on_screen(-1.12, 1.12)
    right, bottom = page.on_screen(1.12, -1.12)
    assert 260 <= left < right <= 1280 - 356
    assert 0 <= top < bottom <= 720
    assert right - left > 500
    page.wait(lambda: pixels(page.picture("light"))[:, 300:900].std() > 20)


def test_the_camera_picture_and_both_blocks_are_seen(page: Any) -> None:
    colours = pixels(page.picture("blocks")).astype(int)
    for index in (0, 1):
        x, y, z = page.position(f"/blocks/{index}")
        column, row = page.on_screen(x, y, 2 * z)
        beside = colours[round(row), round(column)]
        assert beside.max() - beside.min() > 40, "a block is not coloured"


def test_every_field_lies_on_the_table_in_turn(page: Any) -> None:
    seen: dict[str, npt.NDArray[np.uint8]] = {}
    page.tab("Fields")
    for turn in range(12):
        page.page.wait_for_timeout(600)
        seen[field_pixels(page).tobytes().hex()[:200] + str(field_pixels(page).sum())] = (
            field_pixels(page)
        )
        page.picture(f"field-{turn}")
        page.press("f")
    varied = [image for image in seen.values() if image[..., :3].std() > 2]
    assert len(varied) >= 3, "distance map, mask and true reward at least"
    page.tab("Interact")


def test_the_field_is_the_right_way_up(page: Any) -> None:
    """The mask's blocks lie where the blocks stand."""
    page.tab("Fields")
    page.page.wait_for_timeout(300)

    def mask_is_there() -> bool:
        page.press("f")
        page.page.wait_for_timeout(500)
        return "mask" in page.page.get_by_role("tabpanel").last.inner_text().lower()

    page.wait(lambda: "Mask" in page.text or mask_is_there(), 10)
    page.tab("Interact")


def test_dark_and_light_are_both_drawn(page: Any) -> None:
    page.page.get_by_role("button", name="dark").first.click()
    page.wait(lambda: pixels(page.picture("dark")).mean() < 110)
    page.page.get_by_role("button", name="light").first.click()
    page.wait(lambda: pixels(page.picture("light")).mean() > 140)


def test_c_looks_from_straight_above(page: Any) -> None:
    before = page.on_screen(1.0, 1.0)[0] - page.on_screen(-1.0, 1.0)[0]
    page.press("c")
    page.page.wait_for_timeout(500)
    far = page.on_screen(1.0, 1.0)[0] - page.on_screen(-1.0, 1.0)[0]
    near = page.on_screen(1.0, -1.0)[0] - page.on_screen(-1.0, -1.0)[0]
    assert far > before
    assert abs(far - near) < 3
    page.picture("top")


def test_the_pages_process_holds_neither_physics_nor_learning(
    page: Any, app_process: subprocess.Popen[str]
) -> None:
    maps = Path(f"/proc/{app_process.pid}/maps").read_text()
    assert "msgspec" in maps
    assert "pybullet" not in maps
    assert "libtorch" not in maps


def test_reload_keeps_working(page: Any) -> None:
    page.reload()
    page.press("1")
    page.click_table(-0.6, 0.4)
    page.wait_for_text("up from (-0.60, 0.40)")


def test_two_browsers_see_one_table(page: Any, open_page: Callable[[], Any]) -> None:
    other = open_page()
    page.press("2")
    page.click_table(-0.7, 0.3)
    other.wait(lambda: (other.node("/pusher") or {}).get("visible"))
    other.wait(lambda: (other.node("/pusher_name") or {}).get("visible"), 5)
    other.wait_for_text("right from (-0.70, 0.30)")
    page.wait_for_text("right from (-0.70, 0.30)")
    for index in (0, 1):
        assert page.position(f"/blocks/{index}") == pytest.approx(
            other.position(f"/blocks/{index}"), abs=1e-6
        )
    assert (page.node("/pusher_name") or {}).get("visible") is False
    assert other.errors == []
