"""Tab *Starts*: where pushes started over a window of training, as in Fig. 6 of the paper."""

from itertools import pairwise

import numpy as np

from app.fields.catalogue import window_of
from app.fields.colormaps import SEQUENTIAL
from app.fields.field_image import field_image, value_span
from app.fields.histogram import fitting_bins, start_histogram, starts_between
from app.fields.legend import legend_html
from app.panels.checks import one_of, whole_number
from app.panels.context import PanelContext
from app.panels.listening import listen, show_value
from app.panels.marked_choice import add_switch
from app.panels.markup import block, dimmed, picture, show, title
from app.panels.watch import Throttle, Watch
from app.snapshot import RunSnapshot, Snapshot

INTERVAL = 0.5
"""Shortest time between two versions of the histogram [s]."""
STRIP_LENGTH, STRIP_BINS = 6, 16
"""Pictures in the strip that shows the whole run, and cells along each side of them."""
WINDOW_SIZES = ("256", "512", "1024", "2048", "4096", "10000", "20000")


class StartsPanel:
    """A histogram, a slider over the run, and the run's evolution in a strip."""

    def __init__(self, context: PanelContext) -> None:
        self._context = context
        self._throttle, self._strip_throttle = Throttle(INTERVAL), Throttle(2.0)
        self._watch, self._strip_watch, self._range_watch = Watch(), Watch(), Watch()
        gui, preferences = context.gui, context.preferences
        self.picture = gui.add_html(_empty_html())
        self.follow = add_switch(gui, "Follow the run", self._set_follow)
        self.end = gui.add_slider("Window end", 1, 2, 1, 2, visible=False)
        self._size = gui.add_dropdown(
            "Window", WINDOW_SIZES, hint="Pushes", initial_value=str(preferences.window_size)
        )
        self.strip = gui.add_html("")
        listen(self.end, lambda value: whole_number("window end", 1, int(self.end.max))(value),
               self._set_end, context.report)  # fmt: skip
        listen(self._size, one_of("window", WINDOW_SIZES), self._set_size, context.report)

    def _set_follow(self, is_on: bool) -> None:
        self._context.preferences.window_end = None if is_on else int(self.end.value)

    def _set_end(self, value: int) -> None:
        self._context.preferences.window_end = value

    def _set_size(self, value: str) -> None:
        self._context.preferences.window_size = int(value)

    def update(self, snapshot: Snapshot, now: float) -> None:
        """Show a snapshot."""
        if not self._throttle.is_due(now):
            return
        self.follow.show(0 if self._context.preferences.window_end is None else 1)
        window = window_of(snapshot, self._context.preferences)
        run = snapshot.run
        if run is None or window is None:
            if self._watch.has_changed(None):
                show(self.picture, _empty_html())
                self.end.visible = self.strip.visible = False
            return
        self._update_slider(run, window[1])
        if self._watch.has_changed(run.run_dir, window, run.revision):
            show(self.picture, self._histogram(run, window))
        if self._strip_throttle.is_due(now) and self._strip_watch.has_changed(
            run.run_dir, run.revision
        ):
            self.strip.visible = True
            show(self.strip, self._evolution(run))

    def _update_slider(self, run: RunSnapshot, end: int) -> None:
        newest = max(2, int(run.start_steps[-1]))
        if self._range_watch.has_changed(newest):
            self.end.max = newest
            self.end.visible = True
        if self._context.preferences.window_end is None:
            show_value(self.end, max(1, end))

    def _histogram(self, run: RunSnapshot, window: tuple[int, int]) -> str:
        starts = starts_between(run.starts, run.start_steps, *window)
        workspace = self._context.workspace
        counts = start_histogram(starts, workspace, fitting_bins(run.starts, workspace))
        span = (0.0, max(1.0, float(counts.max())))
        summary = f"{len(starts):,} pushes"
        if len(starts):
            x, y = np.round(starts.mean(axis=0), 2) + 0.0  # no "-0.00"
            summary += f" · mean ({x:.2f}, {y:.2f}) m · spread {starts.std(axis=0).mean():.2f} m"
        return block(
            title(f"Push starts, steps {window[0]:,} to {window[1]:,}"),
            picture(field_image(counts, span, SEQUENTIAL), "histogram of push starts"),
            legend_html(span, SEQUENTIAL, "pushes"),
            dimmed(summary),
        )

    def _evolution(self, run: RunSnapshot) -> str:
        edges = np.linspace(0, int(run.start_steps[-1]), STRIP_LENGTH + 1).astype(int)
        workspace = self._context.workspace
        num_bins = min(STRIP_BINS, fitting_bins(run.starts, workspace))
        figures = []
        for first, last in pairwise(edges):
            starts = starts_between(run.starts, run.start_steps, int(first) + 1, int(last))
            counts = start_histogram(starts, workspace, num_bins)
            image = field_image(counts, value_span(counts), SEQUENTIAL)
            label = f"{last / 1000:.1f}k" if last >= 1000 else str(last)
            figures.append(
                f'<div style="flex:1;min-width:0">{picture(image, f"starts until {last}")}'
                f"{dimmed(label)}</div>"
            )
        strip = f'<div style="display:flex;gap:3px">{"".join(figures)}</div>'
        return block(title("Over the whole run, each its own range"), strip)


def _empty_html() -> str:
    return block(
        title("Push starts"),
        dimmed("Where training starts its pushes appears here once a run is under way."),
    )
