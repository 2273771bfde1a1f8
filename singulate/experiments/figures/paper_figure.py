"""What a figure of the paper consists of here."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from singulate.engine import Engine
from singulate.experiments.cell_store import CellStore
from singulate.experiments.figures.plan import Plan
from singulate.experiments.figures.published import Published

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Data = Mapping[str, Any]
"""The raw numbers of a figure, plain values for JSON."""


@dataclass(frozen=True)
class Sources:
    """Where a figure takes its numbers from.

    Attributes:
        plan: How much is computed.
        store: The trainings.
        engine: Where pushes are simulated.
        published: Trainings that are not there, but whose numbers are.
    """

    plan: Plan
    store: CellStore
    engine: Engine
    published: Published = field(default_factory=Published)


@dataclass(frozen=True)
class PaperFigure:
    """One figure.

    Attributes:
        name: Such as ``fig3``.
        title: What it shows.
        variants: Trainings that it needs, keys of `VARIANTS`.
        measure: Its numbers; None where a training that it cannot do without is not finished.
        draw: The picture of these numbers.
        page: What else to write, in Markdown, beside the picture; None for nothing.
    """

    name: str
    title: str
    variants: tuple[str, ...]
    measure: Callable[[Sources], Data | None]
    draw: Callable[[Data], "Figure"]
    page: Callable[[Data, Plan], str] | None = None
