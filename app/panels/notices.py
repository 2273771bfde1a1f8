"""What went wrong and what to do, on the page."""

from app.commands import DismissNotice
from app.panels.context import PanelContext
from app.panels.listening import on_press
from app.panels.markup import block, escape, show
from app.panels.watch import Watch
from app.snapshot import Notice, Snapshot

MOST_SHOWN = 3


class NoticesView:
    """The newest notices in a quiet box, and one button that takes them away."""

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self._watch = Watch()
        self._notices: tuple[Notice, ...] = ()
        self.html = context.gui.add_html("", visible=False)
        self._dismiss = context.secondary.add("Dismiss", visible=False)
        on_press(self._dismiss, self._dismiss_all)

    def _dismiss_all(self) -> None:
        for notice in self._notices:
            self._context.submit(DismissNotice(notice.notice_id))

    def update(self, snapshot: Snapshot) -> None:
        """Show the notices of a snapshot."""
        if not self._watch.has_changed(snapshot.notices):
            return
        self._notices = snapshot.notices
        show(self.html, notices_html(snapshot.notices))
        self.html.visible = self._dismiss.visible = bool(snapshot.notices)


def notices_html(notices: tuple[Notice, ...]) -> str:
    """The newest notices, newest first."""
    boxes = []
    for notice in reversed(notices[-MOST_SHOWN:]):
        colour = "#e03131" if notice.is_error else "#1c7ed6"
        boxes.append(
            f'<div role="alert" style="border-left:3px solid {colour};padding:2px 0 2px 8px;'
            f'margin-bottom:4px;font-size:12px;line-height:17px">{escape(notice.text)}</div>'
        )
    hidden = len(notices) - MOST_SHOWN
    if hidden > 0:
        boxes.append(f"<div>and {hidden} more</div>")
    return block(*boxes)
