"""Keys and entries of the command palette."""

from collections.abc import Callable
from typing import Any

import viser
from viser._messages import HotkeyKey

from singulate.exceptions import InvalidValueError

Binding = tuple[HotkeyKey, str, Callable[[], None]]
"""A key, its name in the command palette and what it does."""


def bind_keys(
    gui: viser.GuiApi, bindings: tuple[Binding, ...], report: Callable[[str], None]
) -> tuple[viser.CommandHandle, ...]:
    """Register keys; their actions run in viser's thread pool and may block.

    Args:
        gui: A client's own.
        bindings: Keys without modifiers.
        report: Shows one line to the person when an action does not accept a value.
    """
    return tuple(_bind(gui, binding, report) for binding in bindings)


def _bind(
    gui: viser.GuiApi, binding: Binding, report: Callable[[str], None]
) -> viser.CommandHandle:
    key, label, act = binding
    handle = gui.add_command(label, hotkey=key)

    def on_trigger(_event: Any) -> None:
        try:
            act()
        except InvalidValueError as error:
            report(str(error))

    handle.on_trigger(on_trigger)
    return handle
