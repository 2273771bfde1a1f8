"""A person's choices survive a reload: kept in their own browser, checked on the way back."""

import json
import threading

import viser

from app.fields.catalogue import FIELDS_BY_KEY
from app.panels.checks import Check, flag, number, one_of
from app.preferences import CHOICES, SPANS, Preferences
from singulate.exceptions import InvalidValueError

STORAGE_KEY = "singulate"
ANSWER_TIMEOUT_S = 10.0
MAX_LENGTH = 2000

CHECKS: dict[str, Check[object]] = {
    "field": one_of("field", FIELDS_BY_KEY),
    "choice": one_of("choice", CHOICES),
    "span": one_of("span", SPANS),
    "opacity": number("opacity", 0.0, 1.0),
    "shows_all_directions": flag("shows_all_directions"),
    "is_dark": flag("is_dark"),
}
"""Which choices are kept, and what may come back."""


def to_text(preferences: Preferences) -> str:
    """The kept choices as JSON."""
    return json.dumps({name: getattr(preferences, name) for name in CHECKS})


def restore(preferences: Preferences, text: str) -> None:
    """Take over kept choices; whatever is damaged, unknown or out of range is left out."""
    try:
        kept = json.loads(text[:MAX_LENGTH])
    except (json.JSONDecodeError, RecursionError):
        return
    if not isinstance(kept, dict):
        return
    for name, check in CHECKS.items():
        if name not in kept:
            continue
        try:
            setattr(preferences, name, check(kept[name]))
        except InvalidValueError:
            continue


class Remembered:
    """Reads the choices once from the browser and writes them when they change.

    Args:
        client: The browser.
        preferences: Its choices; changed only inside `update`.
    """

    def __init__(self, client: viser.ClientHandle, preferences: Preferences) -> None:
        self._client, self._preferences = client, preferences
        self._answer: str | None = None
        self._has_answered = threading.Event()
        self._written = to_text(preferences)
        threading.Thread(target=self._ask, name="remembered", daemon=True).start()

    def _ask(self) -> None:
        try:
            self._answer = self._client.local_storage.get_item(
                STORAGE_KEY, timeout=ANSWER_TIMEOUT_S
            )
        except (TimeoutError, RuntimeError):  # gone, silent, or storage is blocked
            return
        self._has_answered.set()

    def update(self) -> None:
        """Take over what was kept, once; afterwards keep what has changed."""
        if not self._has_answered.is_set():
            return
        answer, self._answer = self._answer, None
        if answer is not None:
            restore(self._preferences, answer)
            self._written = to_text(self._preferences)
            return
        text = to_text(self._preferences)
        if text != self._written:
            self._written = text
            self._client.local_storage.set_item(STORAGE_KEY, text)
