"""Colours of the three-dimensional scene, RGB in 0 to 255."""

from dataclasses import dataclass

from singulate.simulation.palette import BLOCK_COLOURS as SEEN_BY_CAMERAS

Colour = tuple[int, int, int]

BLOCK_COLOURS: tuple[Colour, ...] = tuple(
    (round(255 * red), round(255 * green), round(255 * blue))
    for red, green, blue, _ in SEEN_BY_CAMERAS
)
"""One for each block, again from the start after the last; the same as in the camera's pictures."""

PUSHER_COLOUR: Colour = (56, 61, 71)
AIM_COLOUR: Colour = (214, 52, 16)


@dataclass(frozen=True)
class Surface:
    """Colours of the table in a light or a dark page."""

    table: Colour
    border: Colour
    grid: Colour
    print: Colour
    ghost: Colour


LIGHT = Surface(
    table=(221, 221, 219),
    border=(132, 134, 140),
    grid=(196, 198, 202),
    print=(96, 99, 106),
    ghost=(138, 142, 150),
)
DARK = Surface(
    table=(47, 50, 57),
    border=(140, 144, 152),
    grid=(84, 88, 95),
    print=(170, 173, 180),
    ghost=(168, 172, 180),
)


def surface(is_dark: bool) -> Surface:
    """Colours for one of the two themes."""
    return DARK if is_dark else LIGHT
