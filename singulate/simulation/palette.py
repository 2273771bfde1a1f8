"""Colours of what the cameras see, RGBA in [0, 1]."""

Colour = tuple[float, float, float, float]

TABLE_COLOUR = (0.93, 0.92, 0.89, 1.0)
BLOCK_COLOURS: tuple[Colour, ...] = (
    (0.27, 0.47, 0.67, 1.0),
    (0.93, 0.60, 0.33, 1.0),
    (0.40, 0.66, 0.47, 1.0),
    (0.80, 0.45, 0.47, 1.0),
    (0.55, 0.48, 0.70, 1.0),
    (0.85, 0.73, 0.38, 1.0),
    (0.42, 0.68, 0.72, 1.0),
    (0.72, 0.53, 0.42, 1.0),
)


def block_colour(index: int) -> Colour:
    """Colour of a scene's block by its number; after the last colour they begin anew."""
    return BLOCK_COLOURS[index % len(BLOCK_COLOURS)]
