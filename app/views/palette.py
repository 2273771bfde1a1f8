"""Colours of the three-dimensional scene, RGB in 0 to 255."""

from dataclasses import dataclass

Colour = tuple[int, int, int]

BLOCK_COLOURS: tuple[Colour, ...] = (
    (69, 120, 171),
    (237, 153, 84),
    (102, 168, 120),
    (204, 115, 120),
    (140, 122, 178),
    (217, 186, 97),
    (107, 173, 184),
    (184, 135, 107),
)
"""One for each block, again from the start after the last; the camera's pictures use the same."""

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
    table=(248, 247, 244),
    border=(132, 134, 140),
    grid=(196, 198, 202),
    print=(96, 99, 106),
    ghost=(138, 142, 150),
)
DARK = Surface(
    table=(62, 65, 71),
    border=(140, 144, 152),
    grid=(84, 88, 95),
    print=(170, 173, 180),
    ghost=(168, 172, 180),
)


def surface(is_dark: bool) -> Surface:
    """Colours for one of the two themes."""
    return DARK if is_dark else LIGHT
