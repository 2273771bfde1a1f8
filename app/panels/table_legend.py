"""Left panel: what the colours on the table mean."""

from app.fields.catalogue import FIELDS_BY_KEY
from app.fields.draped import DrapedField
from app.panels.context import PanelContext
from app.panels.field_age import policy_line, reward_map_line
from app.panels.markup import block, dimmed, show, title
from app.snapshot import Snapshot


class TableLegend:
    """Name, colours, range and age of the field on the table, whichever tab is open."""

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self.legend = context.gui.add_html("")

    def update(self, snapshot: Snapshot, draped: DrapedField | None) -> None:
        """Show a snapshot; `draped` is what lies on this client's table."""
        show(self.legend, _legend_html(snapshot, self._context.preferences.field, draped))


def _legend_html(snapshot: Snapshot, key: str, draped: DrapedField | None) -> str:
    kind = FIELDS_BY_KEY[key]
    if key == "none":
        return block(dimmed("Nothing lies on the table."))
    notes = []
    if "reward_map" in kind.needs:
        notes.append(reward_map_line(snapshot))
    if kind.needs & {"q_map", "start_density"}:
        notes.append(policy_line(snapshot))
    if draped is None:
        return block(title(kind.label, "nothing to show"), *map(dimmed, notes))
    if len(notes) == 1:
        return block(title(draped.label, notes[0]), draped.legend)
    return block(title(draped.label), draped.legend, *map(dimmed, notes))
