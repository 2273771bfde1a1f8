"""Every kind of input, with values that are right and values that are not."""

from collections.abc import Callable
from typing import Any

import pytest

from app.security.values import is_allowed_value, let_scripts_set

MAKERS: dict[str, tuple[Callable[[Any], Any], tuple[object, ...], tuple[object, ...]]] = {
    "button": (lambda gui: gui.add_button("b"), (True,), (False, 1, "yes")),
    "checkbox": (lambda gui: gui.add_checkbox("c", False), (True, False), (1, "true", None)),
    "text": (lambda gui: gui.add_text("t", ""), ("", "abc"), (1, "x" * 10_001, "a\0b")),
    "dropdown": (lambda gui: gui.add_dropdown("d", ("a", "b")), ("a", "b"), ("c", 0, ["a"])),
    "button group": (lambda gui: gui.add_button_group("g", ("a", "b")), ("b",), ("c", True)),
    "whole slider": (lambda gui: gui.add_slider("s", 0, 9, 1, 3), (0, 9), (10, 2.5, "2")),
    "number": (lambda gui: gui.add_number("n", 1.0, min=0.0), (0, 1e6), (-1, 1e30, None)),
    "open number": (lambda gui: gui.add_number("n", 1), (-5, 5), (2.5, True)),
    "range": (
        lambda gui: gui.add_multi_slider("m", 0, 9, 1, (2, 5)),
        ([0, 9], [4, 4]),
        ([5, 2], [0, 10], [1], 3),
    ),
    "vector": (
        lambda gui: gui.add_vector2("v", (0.0, 0.0), min=(-1.0, -1.0), max=(1.0, 1.0)),
        ([1, -1.0],),
        ([2.0, 0.0], [0.0], [0.0, float("nan")], "ab"),
    ),
    "free vector": (lambda gui: gui.add_vector3("v", (0.0, 0.0, 0.0)), ([9, 9, 9],), ([9, 9],)),
    "colour": (lambda gui: gui.add_rgb("r", (1, 2, 3)), ([0, 255, 9],), ([0, 256, 9], [0.5, 0, 0])),
    "upload": (lambda gui: gui.add_upload_button("u"), (), (True, b"data")),
}


@pytest.mark.parametrize("kind", MAKERS)
def test_inputs_take_what_their_kind_allows(door: Any, kind: str) -> None:
    make, right, wrong = MAKERS[kind]
    handle = make(door.server.gui)
    assert [is_allowed_value(handle, value) for value in right] == [True] * len(right)
    assert [is_allowed_value(handle, value) for value in wrong] == [False] * len(wrong)


def test_removed_and_disabled_inputs_take_nothing(door: Any) -> None:
    box = door.server.gui.add_checkbox("c", False)
    assert is_allowed_value(box, True)
    box.disabled = True
    assert not is_allowed_value(box, True)
    box.disabled = False
    box.remove()
    assert not is_allowed_value(box, True)


def test_hidden_inputs_take_nothing_but_from_scripts_of_the_page(door: Any) -> None:
    text = door.server.gui.add_text("t", "", visible=False)
    assert not is_allowed_value(text, "abc")
    let_scripts_set(text)
    assert is_allowed_value(text, "abc")
    assert not is_allowed_value(text, 1)
