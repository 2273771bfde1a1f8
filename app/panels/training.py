"""Tab *Training*: curves of the watched run, raw faint behind smoothed."""

import numpy as np
import viser
from viser import uplot

from app.panels.context import PanelContext
from app.panels.curves import CHARTS, ChartSpec, chart_data, find_curve
from app.panels.markup import block, dimmed, show
from app.panels.watch import Throttle, Watch
from app.snapshot import RunSnapshot, Snapshot

CHART_INTERVAL = 1.0
"""Shortest time between two versions of the charts [s]."""
CHART_HEIGHT = 120
NO_POINTS = uplot.Series_Points(show=False)
NO_TICKS = uplot.Axis_Ticks(show=False)
RAW, SMOOTH = "rgba(34, 139, 230, 0.35)", "#228be6"


class TrainingPanel:
    """One small chart for each metric that the run has."""

    def __init__(self, context: PanelContext) -> None:
        self._throttle, self._watch = Throttle(CHART_INTERVAL), Watch()
        self.text = context.gui.add_html(_text_html(None))
        self.charts = [(spec, _add_chart(context.gui, spec)) for spec in CHARTS]

    def update(self, snapshot: Snapshot, now: float) -> None:
        """Show a snapshot."""
        run = snapshot.run
        if not self._throttle.is_due(now):
            return
        if not self._watch.has_changed(run and (run.run_dir, run.revision)):
            return
        show(self.text, _text_html(run))
        for spec, chart in self.charts:
            found = None if run is None else find_curve(spec, run.curves)
            data = None if found is None else chart_data(found[1])
            chart.visible = data is not None and len(data[0]) > 1
            if data is not None and chart.visible:
                chart.data = data


def _add_chart(gui: viser.GuiApi, spec: ChartSpec) -> viser.GuiUplotHandle:
    empty = np.array([0.0, 1.0])
    return gui.add_uplot(
        (empty, empty, empty),
        (
            uplot.Series(label="push"),
            uplot.Series(label="raw", stroke=RAW, width=1, points=NO_POINTS),
            uplot.Series(label="smoothed", stroke=SMOOTH, width=2, points=NO_POINTS),
        ),
        title=spec.title,
        scales={"x": uplot.Scale(time=False)},
        axes=(
            uplot.Axis(size=24, ticks=NO_TICKS),
            uplot.Axis(size=58, ticks=NO_TICKS),
        ),
        legend=uplot.Legend(show=False),
        padding=(4, 12, 0, 0),
        height=CHART_HEIGHT,
        visible=False,
    )


def _text_html(run: RunSnapshot | None) -> str:
    if run is None or not run.curves:
        return block(dimmed("Curves appear here once a run has finished its first episodes."))
    return block(dimmed(run.name))
