"""Blocks are dragged over the table in a real browser, and every field follows."""

import math
import re
from typing import Any

import pytest

pytestmark = pytest.mark.browser

OF_THIS_TABLE = re.compile("(\\d+) \N{MULTIPLICATION SIGN} \\d+( \N{MIDDLE DOT} \\d+ % done)?\n")
"""The legend of a true reward that is not of an earlier table."""


def shown_resolution(page: Any) -> int:
    """Cells along a side of the true reward on the table; 0 where it is of an earlier table."""
    found = OF_THIS_TABLE.search(page.text)
    return int(found[1]) if found else 0


def test_true_rewards_follow_a_dragged_block_coarse_first(page: Any) -> None:
    before, camera = page.position("/blocks/0"), page.camera
    page.wait(lambda: shown_resolution(page) > 0)
    page.grab_block(0)
    for place in ((-0.6, 0.5), (0.5, 0.6)):
        page.drag_block(0, *place)
        page.wait(lambda: shown_resolution(page) > 0)
    page.wait(lambda: shown_resolution(page) == 64 and "% done" not in page.text)
    page.page.mouse.up()
    page.wait_for_text("rearranged")
    assert page.camera == pytest.approx(camera), "the drag moved the camera too"
    page.press("z")
    page.wait(lambda: page.position("/blocks/0") == pytest.approx(before, abs=1e-4))


def test_a_block_is_not_dragged_through_another(page: Any) -> None:
    other = page.position("/blocks/1")
    page.grab_block(0)
    height = 2 * page.position("/blocks/0")[2]
    page.page.mouse.move(*page.on_screen(*other[:2], height), steps=6)
    page.page.wait_for_timeout(500)
    moved = page.position("/blocks/0")
    page.page.mouse.up()
    assert page.position("/blocks/1") == other
    sides = moved[2] + other[2]
    assert max(abs(moved[0] - other[0]), abs(moved[1] - other[1])) > sides - 1e-3


def test_the_aim_is_where_a_block_was_let_go(page: Any) -> None:
    page.grab_block(0)
    page.drag_block(0, -0.6, 0.5)
    page.page.mouse.up()
    # The pointer is on top of the block, so what is under it on the table lies behind it.
    page.wait(lambda: math.dist(page.position("/aim")[:2], (-0.6, 0.5)) < 0.25)
    page.wait_for_text("rearranged")


def test_shift_turns_a_block_in_its_place(page: Any) -> None:
    x, y, z = page.position("/blocks/0")
    column, row = page.on_screen(x, y, 2 * z)
    mouse = page.page.mouse
    page.page.keyboard.down("Shift")
    mouse.move(column, row)
    mouse.down()
    mouse.move(column + 60, row, steps=4)
    page.wait(lambda: abs(page.node("/blocks/0")["quaternion"][2]) > 0.1)
    mouse.up()
    page.page.keyboard.up("Shift")
    assert math.dist(page.position("/blocks/0")[:2], (x, y)) < 0.1


def test_buttons_add_and_remove_a_block(page: Any) -> None:
    assert not page.is_visible("/blocks/2")
    page.button("Add").click()
    page.wait(lambda: page.is_visible("/blocks/2"))
    first, second, added = places = [page.position(f"/blocks/{index}") for index in range(3)]
    assert min(math.dist(added[:2], other[:2]) for other in (first, second)) > 0.2
    page.button("Remove").click()
    page.wait(lambda: not page.is_visible("/blocks/2"))
    page.wait(lambda: {page.position("/blocks/0"), page.position("/blocks/1")} < set(places))
