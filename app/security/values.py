"""Whether a browser may set an input of the page to a value."""

from collections.abc import Callable, Sequence
from typing import Any
from weakref import WeakValueDictionary

import viser

from app.security.conformance import is_number, is_text, is_whole

_carriers: "WeakValueDictionary[str, Any]" = WeakValueDictionary()


def let_scripts_set(handle: Any) -> None:
    """Accept values for a hidden input: a script of the page sets it, and nobody by hand."""
    _carriers[handle._impl.uuid] = handle


def is_allowed_value(handle: Any, value: object) -> bool:
    """Check a value against an input's type, range and options.

    viser's page does the same before it sends; somebody who speaks to the server directly does
    not.

    Args:
        handle: An input of the page.
        value: What a browser wants it to become, as msgpack decodes it.

    Returns:
        False also for disabled, removed and hidden inputs (but see `let_scripts_set`) and for kinds
        that the page never uses.
    """
    is_shown = handle.visible or handle._impl.uuid in _carriers
    if handle._impl.removed or handle.disabled or not is_shown:
        return False
    return any(isinstance(handle, kind) and check(handle, value) for kind, check in _CHECKS.items())


def _is_number_in_range(handle: Any, value: object) -> bool:
    is_right = is_whole if isinstance(handle.value, int) else is_number
    return is_right(value) and _is_between(value, handle.min, handle.max)


def _is_vector(handle: Any, value: object) -> bool:
    if not _is_list_of(value, len(handle.value), is_number):
        return False
    lower = handle.min or (None,) * len(handle.value)
    upper = handle.max or (None,) * len(handle.value)
    assert isinstance(value, Sequence)
    return all(map(_is_between, value, lower, upper))


def _is_multi_slider(handle: Any, value: object) -> bool:
    if not _is_list_of(value, len(handle.value), is_number):
        return False
    assert isinstance(value, Sequence)
    return list(value) == sorted(value) and all(
        _is_between(item, handle.min, handle.max) for item in value
    )


def _is_colour(handle: Any, value: object) -> bool:
    if not _is_list_of(value, len(handle.value), is_whole):
        return False
    assert isinstance(value, Sequence)
    return all(0 <= channel <= 255 for channel in value)


def _is_list_of(value: object, length: int, check: Callable[[object], bool]) -> bool:
    return isinstance(value, list | tuple) and len(value) == length and all(map(check, value))


def _is_between(value: Any, lower: float | None, upper: float | None) -> bool:
    return (lower is None or value >= lower) and (upper is None or value <= upper)


_CHECKS: dict[type, Callable[[Any, object], bool]] = {
    viser.GuiButtonHandle: lambda handle, value: value is True,
    viser.GuiCheckboxHandle: lambda handle, value: isinstance(value, bool),
    viser.GuiTextHandle: lambda handle, value: is_text(value),
    viser.GuiDropdownHandle: lambda handle, value: is_text(value) and value in handle.options,
    viser.GuiButtonGroupHandle: lambda handle, value: is_text(value) and value in handle.options,
    viser.GuiSliderHandle: _is_number_in_range,
    viser.GuiNumberHandle: _is_number_in_range,
    viser.GuiMultiSliderHandle: _is_multi_slider,
    viser.GuiVector2Handle: _is_vector,
    viser.GuiVector3Handle: _is_vector,
    viser.GuiRgbHandle: _is_colour,
    viser.GuiRgbaHandle: _is_colour,
}
