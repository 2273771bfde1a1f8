"""Clicks and drags in a real browser move the real pusher."""

import math
from typing import Any

import pytest

pytestmark = pytest.mark.browser

PLACES = {
    "1": ((-0.5, -0.3), (0.0, 1.0)),
    "2": ((-0.55, 0.62), (1.0, 0.0)),
    "3": ((-0.8, 0.8), (0.0, -1.0)),
    "4": ((0.31, 0.45), (-1.0, 0.0)),
}


def check_push(page: Any, start: tuple[float, float], direction: tuple[float, float]) -> None:
    """Wait for a push and compare it with the one that was meant, to 2 cm."""
    page.wait(lambda: page.track)
    page.wait(lambda: not page.is_pushing)
    assert page.position("/ghost")[:2] == pytest.approx(start, abs=0.02)
    for x, y, _ in page.track:
        along = (x - start[0]) * direction[0] + (y - start[1]) * direction[1]
        aside = (x - start[0]) * direction[1] - (y - start[1]) * direction[0]
        assert -0.02 <= along <= 0.52
        assert abs(aside) < 0.02
    assert math.dist(page.track[-1][:2], start) > 0.1


@pytest.mark.parametrize("key", PLACES)
def test_a_click_pushes_at_the_clicked_place_in_the_chosen_direction(page: Any, key: str) -> None:
    start, direction = PLACES[key]
    page.press(key)
    page.record_pusher()
    page.click_table(*start)
    check_push(page, start, direction)


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
    page.press("4")
    camera = page.camera
    page.record_pusher()
    page.drag_table(start, end)
    check_push(page, start, direction)
    assert page.camera == pytest.approx(camera), "the drag moved the camera too"


def test_dragging_with_the_right_button_moves_the_camera_and_pushes_nothing(page: Any) -> None:
    camera, before = page.camera, page.position("/ghost")
    mouse = page.page.mouse
    mouse.move(*page.on_screen(0.0, 0.5))
    mouse.down(button="right")
    mouse.move(*page.on_screen(0.3, 0.5), steps=5)
    mouse.up(button="right")
    page.wait(lambda: page.camera != pytest.approx(camera, abs=0.05))
    page.page.wait_for_timeout(300)
    assert page.position("/ghost") == before
    page.look_from_top()


def test_a_persons_own_push_is_called_theirs(page: Any) -> None:
    told = "you: right from (-0.45, 0.72)"
    assert told not in page.text
    page.press("2")
    page.click_table(-0.45, 0.72)
    page.wait_for_text(told)


def test_undo_brings_the_blocks_back(page: Any) -> None:
    x, y, _ = before = page.position("/blocks/0")
    page.press("2")
    page.click_table(x - 0.3, y)
    page.wait(lambda: page.position("/blocks/0") != pytest.approx(before, abs=0.05))
    page.wait(lambda: not page.is_pushing)
    assert page.position("/blocks/0") != pytest.approx(before, abs=0.05)
    page.press("z")
    page.wait(lambda: page.position("/blocks/0") == pytest.approx(before, abs=1e-4))


def test_the_aim_arrow_follows_the_pointer_and_keeps_its_place_when_turned(page: Any) -> None:
    page.press("1")
    for place in ((0.2, 0.6), (-0.6, -0.4)):
        page.page.mouse.move(*page.on_screen(*place))
        page.wait(lambda place=place: page.position("/aim")[:2] == pytest.approx(place, abs=0.02))
    before = page.node("/aim")
    assert before["visible"] is True
    page.press("2")
    page.wait(lambda: page.node("/aim")["quaternion"] != pytest.approx(before["quaternion"]))
    assert page.position("/aim") == tuple(before["position"])
    page.page.mouse.move(5, 5)
    page.page.wait_for_timeout(200)
    assert page.position("/aim") == tuple(before["position"])
