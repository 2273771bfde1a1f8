"""Clicks and drags in a real browser move the real pusher."""

from typing import Any

import pytest

pytestmark = pytest.mark.browser

PLACES = {
    "1": ((-0.5, -0.3), (0.0, 1.0)),
    "2": ((-0.55, 0.62), (1.0, 0.0)),
    "3": ((-0.8, 0.8), (0.0, -1.0)),
    "4": ((0.31, 0.45), (-1.0, 0.0)),
}


def end_of_push(page: Any) -> tuple[float, float]:
    page.wait(lambda: (page.node("/pusher") or {}).get("visible"), 5)
    page.wait(lambda: not (page.node("/pusher") or {}).get("visible"))
    highest = max(page.track, key=lambda place: place[2])
    return highest[0], highest[1]


@pytest.mark.parametrize("key", PLACES)
def test_a_click_pushes_at_the_clicked_place_in_the_chosen_direction(page: Any, key: str) -> None:
    start, direction = PLACES[key]
    page.press(key)
    page.record_pusher()
    page.click_table(*start)
    end = end_of_push(page)
    assert end[0] == pytest.approx(start[0] + 0.5 * direction[0], abs=0.02)
    assert end[1] == pytest.approx(start[1] + 0.5 * direction[1], abs=0.02)
    first = page.track[0]
    along = (first[0] - start[0]) * direction[0] + (first[1] - start[1]) * direction[1]
    aside = (first[0] - start[0]) * direction[1] - (first[1] - start[1]) * direction[0]
    assert -0.02 <= along < 0.3
    assert abs(aside) < 0.02
    assert page.position("/ghost")[:2] == pytest.approx(start, abs=0.02)


@pytest.mark.parametrize(
    ("start", "end", "direction"),
    [((-0.5, 0.5), (-0.2, 0.56), (1.0, 0.0)), ((-0.3, 0.7), (-0.36, 0.3), (0.0, -1.0))],
)
def test_a_dragged_arrow_sets_start_and_direction(
    page: Any,
    start: tuple[float, float],
    end: tuple[float, float],
    direction: tuple[float, float],
) -> None:
    page.press("1")
    camera = page.page.evaluate("() => window.__viserMutable.camera.position.toArray()")
    page.record_pusher()
    page.drag_table(start, end)
    stop = end_of_push(page)
    assert stop[0] == pytest.approx(start[0] + 0.5 * direction[0], abs=0.02)
    assert stop[1] == pytest.approx(start[1] + 0.5 * direction[1], abs=0.02)
    after = page.page.evaluate("() => window.__viserMutable.camera.position.toArray()")
    assert after == pytest.approx(camera), "the drag moved the camera too"


def test_dragging_with_the_right_button_moves_the_camera_and_pushes_nothing(page: Any) -> None:
    camera = page.page.evaluate("() => window.__viserMutable.camera.position.toArray()")
    before = page.position("/ghost")
    mouse = page.page.mouse
    mouse.move(*page.on_screen(0.0, 0.5))
    mouse.down(button="right")
    mouse.move(*page.on_screen(0.3, 0.5), steps=5)
    mouse.up(button="right")
    page.page.wait_for_timeout(300)
    after = page.page.evaluate("() => window.__viserMutable.camera.position.toArray()")
    assert after != pytest.approx(camera)
    assert page.position("/ghost") == before
    page.press("c")


def test_undo_and_reset_bring_the_blocks_back(page: Any) -> None:
    page.page.wait_for_timeout(300)
    x, y, _ = before = page.position("/blocks/0")
    page.press("2")
    page.record_pusher()
    page.click_table(x - 0.3, y)
    end_of_push(page)
    page.page.wait_for_timeout(300)
    assert page.position("/blocks/0") != pytest.approx(before, abs=0.05)
    page.press("z")
    page.wait(lambda: page.position("/blocks/0") == pytest.approx(before, abs=1e-4))
