"""Widths of the fully connected layers."""

from singulate.exceptions import InvalidValueError

PAPER_NET_ARCH = (128, 64, 64, 32, 16)
"""The paper's network, ReLU after each layer (section 3.3)."""


def check_net_arch(key: str, value: object) -> tuple[int, ...]:
    """Widths of the hidden layers as a tuple.

    Raises:
        InvalidValueError: Unless `value` is a sequence of 1 to 16 widths.
    """
    allowed = "1 to 16 layer widths from 1 to 4096"
    if not isinstance(value, list | tuple) or not 1 <= len(value) <= 16:
        raise InvalidValueError(key, value, allowed)
    for width in value:
        if isinstance(width, bool) or not isinstance(width, int) or not 1 <= width <= 4096:
            raise InvalidValueError(key, value, allowed)
    return tuple(value)
