"""The figures by name; to add one: a file in this folder and one line here."""

from singulate.exceptions import InvalidValueError
from singulate.experiments.figures import autoencoder, fig1, fig2, fig3, fig4, fig5, fig6, ideas
from singulate.experiments.figures.paper_figure import PaperFigure

FIGURES: dict[str, PaperFigure] = {
    module.FIGURE.name: module.FIGURE
    for module in (fig1, fig2, fig3, fig4, fig5, fig6, autoencoder, ideas)
}


def parse_figures(names: list[str]) -> tuple[list[PaperFigure], bool]:
    """Figures by name, each once, in the paper's order.

    Args:
        names: Names, or ``all``; none at all is ``all``.

    Returns:
        The figures, and whether all were asked for, so that claims are judged too.

    Raises:
        InvalidValueError: If there is no such figure.
    """
    for name in names:
        if name != "all" and name not in FIGURES:
            raise InvalidValueError("figure", name, f"{', '.join(FIGURES)}, all")
    is_all = not names or "all" in names
    return [figure for key, figure in FIGURES.items() if is_all or key in names], is_all
