"""Tab *Paper*: its figures, made anew, and what has become of its claims."""

from base64 import b64encode
from pathlib import Path

import viser

from app.panels.context import PanelContext
from app.panels.listening import on_pick
from app.panels.markup import DIM, block, dimmed, escape, title
from app.reproduction import Claim, Reproduction, read_reproduction
from singulate.exceptions import SingulateError

_COLOURS = {"held": "#2f9e44", "partly": "#e67700", "not held": "#e03131"}
_WIDE = "<style>.mantine-Modal-content{flex:0 0 min(960px,92vw)!important}</style>"
"""viser's windows are too narrow for a figure."""
_STYLE = 'style="width:100%;max-height:74vh;object-fit:contain;background:#fff;border-radius:3px"'
_NOTHING = "Not made yet: singulate reproduce all writes the figures and judges the claims."


class PaperPanel:
    """A button for each figure, and the claims with their verdicts.

    Args:
        context: What the panels share.
        directory: Of ``singulate reproduce --out``; by default what comes with the repository.
    """

    def __init__(self, context: PanelContext, directory: Path | None = None) -> None:
        self._context = context
        self._made = Reproduction({}, ())
        problem = _NOTHING
        try:
            self._made = read_reproduction(directory)
        except SingulateError as error:
            problem = str(error)
        names = tuple(self._made.figures)
        self.figures = context.gui.add_button_group("Figure", names or ("none",))
        self.figures.visible = bool(names)
        claims = "".join(map(_claim_html, self._made.claims)) or dimmed(problem)
        self.claims = context.gui.add_html(block(title("Claims"), claims))
        on_pick(self.figures, self.open)

    def open(self, index: int) -> viser.GuiHtmlHandle | None:
        """Show a figure, counted from 0, in a window over the page; None where it is gone."""
        number, path = list(self._made.figures.items())[index]
        try:
            picture = b64encode(path.read_bytes()).decode("ascii")
        except OSError as error:
            self._context.report(f"{path} cannot be read ({error.strerror}).")
            return None
        gui = self._context.gui
        name = f"Figure {number}" if number.isdigit() else number.capitalize()
        modal = gui.add_modal(name)
        with modal:
            source = f"data:image/png;base64,{picture}"
            shown = gui.add_html(f'{_WIDE}<img alt="{name}" src="{source}" {_STYLE}>')
            close = gui.add_button("Close")
        close.on_click(lambda _: modal.close())
        return shown


def _claim_html(claim: Claim) -> str:
    colour = _COLOURS.get(claim.verdict, DIM)
    details = "".join(dimmed(line) for line in (*claim.numbers, claim.reason) if line)
    return (
        f'<div style="padding:6px 0"><b style="color:{colour}">{escape(claim.verdict)}</b> '
        f"{escape(claim.statement)}{dimmed(claim.source)}{details}</div>"
    )
