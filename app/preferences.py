"""What one person has chosen for their own view; nobody else's page changes with it."""

from dataclasses import dataclass

from singulate.geometry import Direction

SPANS = ("each field", "four directions", "reward and Q")
"""What a colour range spans: one map, the maps of all directions, or truth and belief together."""

CHOICES = ("best", "as aimed", *(direction.label for direction in Direction))
"""Which direction of a directional field is drawn."""


@dataclass
class Preferences:
    """Choices of one client; callbacks set them, the main loop reads them.

    Attributes:
        direction: Direction of the next clicked push.
        field: Key of the field on the table, see `app.fields.catalogue`.
        choice: One of `CHOICES`.
        span: One of `SPANS`.
        opacity: Of the field on the table, 0 to 1.
        shows_all_directions: Whether the small multiples are drawn (and their maps computed).
        click_inspects: Whether a click on the table inspects a cell instead of pushing.
        inspected: The inspected place (x, y) [m].
        is_dark: Dark theme.
        window_end: Training step where the window of start positions ends; None follows the run.
        window_size: Training steps in that window.
    """

    direction: Direction = Direction.UP
    field: str = "reward"
    choice: str = "best"
    span: str = "four directions"
    opacity: float = 0.85
    shows_all_directions: bool = True
    click_inspects: bool = False
    inspected: tuple[float, float] | None = None
    is_dark: bool = False
    window_end: int | None = None
    window_size: int = 2048
