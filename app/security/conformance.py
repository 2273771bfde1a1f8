"""Whether decoded data has the shape that a type annotation promises."""

import types
from collections.abc import Callable, Mapping
from typing import Any, Literal, Union, get_args, get_origin

from app.choices import MAX_SEED
from singulate.finite import is_finite_number

MAX_TEXT = 10_000
MAX_MAGNITUDE = MAX_SEED
"""No box of the page takes more."""


def conforms(value: object, annotation: Any) -> bool:
    """Check data against an annotation of one of viser's messages.

    Numbers have to be finite and at most `MAX_MAGNITUDE`, texts at most `MAX_TEXT` long; an int is
    accepted as a float, since Javascript has only one kind of number.

    Args:
        value: Data as msgpack decodes it: lists stand for tuples.
        annotation: ``float``, ``int``, ``bool``, ``str``, ``bytes``, ``Any``, ``Literal``,
            ``Union``, ``tuple`` or ``dict`` of such.
    """
    kind = get_origin(annotation)
    if kind in (Union, types.UnionType):
        return any(conforms(value, option) for option in get_args(annotation))
    check = _COMPOUND.get(kind)
    if check is not None:
        return check(value, get_args(annotation))
    simple = _SIMPLE.get(annotation)
    return simple is not None and simple(value)


def is_number(value: object) -> bool:
    """Whether a value is a finite number of sane size, and no bool."""
    return is_finite_number(value) and abs(value) <= MAX_MAGNITUDE


def is_whole(value: object) -> bool:
    """Whether a value is a whole number."""
    return isinstance(value, int) and is_number(value)


def is_text(value: object) -> bool:
    """Whether a value is a text of sane length."""
    return isinstance(value, str) and len(value) <= MAX_TEXT and "\0" not in value


def _is_tuple(value: object, args: tuple[Any, ...]) -> bool:
    if not isinstance(value, list | tuple):
        return False
    if len(args) == 2 and args[1] is Ellipsis:
        return len(value) <= MAX_TEXT and all(conforms(item, args[0]) for item in value)
    return len(value) == len(args) and all(map(conforms, value, args))


def _is_dict(value: object, args: tuple[Any, ...]) -> bool:
    key, item = args
    return isinstance(value, Mapping) and all(
        conforms(k, key) and conforms(v, item) for k, v in value.items()
    )


def _is_literal(value: object, args: tuple[Any, ...]) -> bool:
    return any(type(value) is type(option) and value == option for option in args)


_SIMPLE: dict[Any, Callable[[object], bool]] = {
    float: is_number,
    int: is_whole,
    bool: lambda value: isinstance(value, bool),
    str: is_text,
    bytes: lambda value: isinstance(value, bytes),
    type(None): lambda value: value is None,
    Any: lambda value: True,
}
_COMPOUND: dict[Any, Callable[[object, tuple[Any, ...]], bool]] = {
    tuple: _is_tuple,
    dict: _is_dict,
    Literal: _is_literal,
}
