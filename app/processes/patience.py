"""How long to wait for an answer."""

import time


class Patience:
    """Notices that somebody who has spoken before no longer answers.

    Args:
        timeout_s: Silence after a question that is too long; None for patience without end.
    """

    def __init__(self, timeout_s: float | None) -> None:
        self._timeout_s = timeout_s
        self._has_spoken = False
        self._asked_at: float | None = None

    @property
    def is_over(self) -> bool:
        """Whether the silence has been too long."""
        if self._timeout_s is None or self._asked_at is None or not self._has_spoken:
            return False
        return time.monotonic() - self._asked_at > self._timeout_s

    def note_question(self) -> None:
        """Something was asked."""
        if self._asked_at is None:
            self._asked_at = time.monotonic()

    def note_answer(self) -> None:
        """Something was said."""
        self._has_spoken = True
        self._asked_at = None

    def start_over(self) -> None:
        """Somebody else is asked from now on, who may take time to begin."""
        self._has_spoken = False
        self._asked_at = None
