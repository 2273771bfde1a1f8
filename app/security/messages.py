"""Which messages of a browser are passed on to viser."""

import dataclasses
from collections.abc import Callable
from typing import Any, get_type_hints

import msgspec.msgpack
from viser import _messages

from app.security.conformance import conforms
from app.security.values import is_allowed_value

FindInput = Callable[[str], Any | None]
"""Gives the input of the page with a uuid, or None."""

KNOWN = {
    message.__name__: message
    for message in (
        _messages.ViewerCameraMessage,
        _messages.ScenePointerMessage,
        _messages.SceneNodeClickMessage,
        _messages.SceneNodeDragMessage,
        _messages.GuiUpdateMessage,
        _messages.CommandTriggerMessage,
        _messages.GetRenderResponseMessage,
        _messages.LocalStorageGetItemResponseMessage,
    )
}
"""What the page sends. File transfers, share tunnels and echoes to other browsers are not in it."""


def is_acceptable(raw: object, find_input: FindInput) -> bool:
    """Judge one message of a browser.

    Args:
        raw: The websocket's frame.
        find_input: Finds the inputs that this browser has been shown.

    Returns:
        Whether it is one of the `KNOWN` messages with exactly its fields and finite numbers, and,
        where it changes an input, changes its value alone and to an allowed one.
    """
    if not isinstance(raw, bytes):
        return False
    try:
        fields = msgspec.msgpack.decode(raw)
    except (msgspec.DecodeError, RecursionError):
        return False
    if not isinstance(fields, dict):
        return False
    kind = fields.pop("type", None)
    message = KNOWN.get(kind) if isinstance(kind, str) else None
    if message is None or not _has_fields(fields, message):
        return False
    if message is _messages.GuiUpdateMessage:
        return _is_allowed_update(fields, find_input)
    return True


def _has_fields(fields: dict[Any, Any], message: type) -> bool:
    hints = get_type_hints(message)
    names = {field.name for field in dataclasses.fields(message)}
    return set(fields) <= names and all(
        name in fields and conforms(fields[name], hints[name])
        for name in names
        if name in fields or _is_required(message, name)
    )


def _is_required(message: type, name: str) -> bool:
    field = next(field for field in dataclasses.fields(message) if field.name == name)
    return field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING


def _is_allowed_update(fields: dict[str, Any], find_input: FindInput) -> bool:
    handle = find_input(fields["uuid"])
    updates = fields["updates"]
    if handle is None or set(updates) != {"value"}:
        return False
    return is_allowed_value(handle, updates["value"])
