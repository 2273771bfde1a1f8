"""Callbacks of widgets: only what a person changed, only checked values, in order."""

from collections.abc import Callable
from typing import Any, TypeVar

import viser
from viser._gui_handles import GuiProgressBarHandle

from app.panels.checks import Check
from singulate.exceptions import InvalidValueError

T = TypeVar("T")
Report = Callable[[str], None]


def listen(
    handle: viser.GuiInputHandle[Any], check: Check[T], act: Callable[[T], None], report: Report
) -> None:
    """Call `act` with every checked value that a browser sends for a widget.

    Values that our own code assigns are skipped (viser runs callbacks for them too, without a
    client), so that showing a state never turns into commanding it. A value that fails its check
    is put back to the last good one and reported. The callback is a coroutine without awaits:
    viser then keeps the order of updates.

    Args:
        handle: The widget.
        check: Returns the value in its proper type or raises `InvalidValueError`.
        act: What to do; it has to return at once.
        report: Shows one line to the person.
    """
    last_good: list[Any] = [handle.value]

    async def on_update(event: viser.GuiEvent[Any]) -> None:
        if event.client is None:
            last_good[0] = handle.value
            return
        try:
            value = check(handle.value)
        except InvalidValueError as error:
            show_value(handle, last_good[0])
            report(str(error))
            return
        last_good[0] = handle.value
        act(value)

    handle.on_update(on_update)


def on_press(
    handle: viser.GuiButtonHandle, act: Callable[[], None], report: Report | None = None
) -> None:
    """Call `act` when a button is pressed; a press of a disabled button is not counted."""

    async def on_click(event: viser.GuiEvent[Any]) -> None:
        if event.client is None or handle.disabled:
            return
        try:
            act()
        except InvalidValueError as error:
            if report is not None:
                report(str(error))

    handle.on_click(on_click)


def on_pick(handle: viser.GuiButtonGroupHandle, act: Callable[[int], object]) -> None:
    """Call `act` with the index of the pressed button of a group; unknown names are not counted."""

    async def on_click(event: viser.GuiEvent[Any]) -> None:
        options = tuple(handle.options)
        if event.client is not None and not handle.disabled and handle.value in options:
            act(options.index(handle.value))

    handle.on_click(on_click)


def show_value(handle: viser.GuiInputHandle[Any] | GuiProgressBarHandle, value: Any) -> None:
    """Assign a widget's value; viser sends nothing where it is the same."""
    handle.value = value  # type: ignore[misc]
