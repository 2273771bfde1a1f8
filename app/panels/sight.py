"""What one person can see of their page, so that nothing else is computed or sent."""

import viser

from app.page_script import run_script
from app.panels.listening import Report, listen
from app.security.values import let_scripts_set
from singulate.exceptions import InvalidValueError

TABLE = "table"
FIELDS, TRAINING, STARTS = "fields", "training", "starts"
EVERYTHING = (TABLE, FIELDS, TRAINING, STARTS)
_LOOK_EVERY_MS = 200


class Sight:
    """Which tabs are open in one browser, and whether its window is looked at at all.

    Everything counts as seen until the browser has told.

    Args:
        client: The browser.
        report: Shows one line to the person.
    """

    def __init__(self, client: viser.ClientHandle, report: Report) -> None:
        self._client = client
        self._seen = frozenset(EVERYTHING)
        told = " ".join(EVERYTHING)
        self._carrier = client.gui.add_text("Seen", told, visible=False)
        let_scripts_set(self._carrier)
        listen(self._carrier, _names, self._see, report)
        run_script(
            client,
            "sight.js",
            carrier=self._carrier._impl.uuid,
            told=told,
            interval_ms=str(_LOOK_EVERY_MS),
        )

    def mark(self, tab: str) -> None:
        """Add to a tab, while it is being filled, what it is found by."""
        self._client.gui.add_html(f'<span data-singulate-tab="{tab}"></span>')

    def shows(self, what: str) -> bool:
        """Whether one of `EVERYTHING` can be seen."""
        return what in self._seen

    def _see(self, names: frozenset[str]) -> None:
        self._seen = names


def _names(value: object) -> frozenset[str]:
    names = frozenset(value.split()) if isinstance(value, str) else None
    if names is None or not names <= set(EVERYTHING):
        raise InvalidValueError("seen", value, f"names out of {', '.join(EVERYTHING)}")
    return names
