"""Messages for people about what went wrong and what to do."""

from app.snapshot import Notice

_MAX_NOTICES = 8


class NoticeBoard:
    """The notices on the page: newest last, bounded, no two alike."""

    def __init__(self) -> None:
        self._next_id = 1
        self.notices: tuple[Notice, ...] = ()

    def add(self, text: str, *, is_error: bool = True) -> None:
        """Show a message; one with the same text is replaced, and the oldest make room."""
        notice = Notice(self._next_id, text, is_error)
        self._next_id += 1
        others = tuple(n for n in self.notices if n.text != text)
        self.notices = (*others, notice)[-_MAX_NOTICES:]

    def dismiss(self, notice_id: int) -> None:
        """Take a message off; one that is gone already is no matter."""
        self.notices = tuple(n for n in self.notices if n.notice_id != notice_id)
