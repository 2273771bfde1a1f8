"""What the last push was expected to bring, what it brought, and what the camera saw."""

import viser

from app.fields.field_image import segment_image
from app.panels.markup import block, dimmed, escape, picture, show, table, title
from app.panels.naming import name_for
from app.panels.watch import Watch
from app.snapshot import PushReport

OUTCOMES = {
    "success": "singulated",
    "empty": "nothing moved",
    "inside": "started inside a block",
    "off_table": "a block left the table",
    "not_separated": "not separated",
    "simulation_error": "the physics went wrong; undone",
}
TERM_LABELS = {
    "start": "close start",
    "distance": "distance gained",
    "inside": "inside penalty",
    "success": "success",
}


class PushReportView:
    """A table of reward terms over two small segmentations.

    Args:
        gui: Where it is added.
        own_name: What the others call this person.
    """

    def __init__(self, gui: viser.GuiApi, own_name: str = "") -> None:
        self._own_name = own_name
        self._watch = Watch()
        self.html = gui.add_html(push_report_html(None))

    def update(self, report: PushReport | None) -> None:
        """Show the last push, if it is another one or its prediction has come."""
        parts: tuple[object, ...] = (None,)
        if report is not None:
            actual = (report.label_images[1], report.push, report.reward)
            parts = (*actual, report.predicted, report.by)
        if self._watch.has_changed(*parts):
            show(self.html, push_report_html(report, self._own_name))


def push_report_html(report: PushReport | None, own_name: str = "") -> str:
    """The report as HTML, for the person whom the others call `own_name`."""
    if report is None:
        hint = "Click the table to push, or drag an arrow. The result appears here."
        return block(title("Last push"), dimmed(hint))
    x, y = report.push.start
    outcome = OUTCOMES.get(report.outcome, report.outcome)
    direction = report.push.nearest_direction.label
    where = f"{name_for(own_name, report.by)}: {direction} from ({_metres(x)}, {_metres(y)}) m"
    return block(
        title(f"Last push: {outcome}"),
        dimmed(where),
        '<div style="display:flex;gap:16px;padding-top:4px">'
        f'<div style="flex:1">{_terms_table(report)}</div>{_segmentations(report)}</div>',
    )


def _metres(value: float) -> str:
    return f"{round(value, 2) + 0.0:.2f}"  # no -0.00


def _terms_table(report: PushReport) -> str:
    rows = [
        (escape(TERM_LABELS.get(name, name)), "", _points(value))
        for name, value in report.weighted_terms.items()
    ]
    predicted = "\N{EN DASH}" if report.predicted is None else _points(report.predicted)
    rows.append(("<b>reward</b>", predicted, f"<b>{_points(report.reward)}</b>"))
    if report.predicted is not None:
        error = report.predicted - report.reward
        rows.append(("error", "", f"{error:+.0f}"))
    return table(rows, ("", "predicted", "actual"))


def _segmentations(report: PushReport) -> str:
    figures = "".join(
        f"<div>{picture(segment_image(image), f'segmentation {when}')}"
        f"{dimmed(f'{when}: {count} part' + ('' if count == 1 else 's'))}</div>"
        for when, image, count in zip(
            ("before", "after"), report.label_images, report.num_segments, strict=True
        )
    )
    return f'<div style="width:88px">{figures}</div>'


def _points(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 0.5 else "0"
