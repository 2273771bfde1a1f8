import numpy as np

from app.panels.training import TrainingPanel
from app.snapshot import Curve


def test_only_charts_with_data_are_there(context, make_snapshot):
    panel = TrainingPanel(context)
    panel.update(make_snapshot(), 0.0)
    assert [spec.title for spec, chart in panel.charts if chart.visible] == ["Return"]
    _, chart = panel.charts[0]
    assert [len(part) for part in chart.data] == [100, 100, 100]


def test_charts_change_at_most_once_a_second_and_only_with_the_run(
    context, make_snapshot, make_run
):
    panel = TrainingPanel(context)
    panel.update(make_snapshot(), 0.0)
    _, chart = panel.charts[0]
    first = chart.data
    longer = Curve(np.arange(300.0), np.arange(300.0))
    more = make_snapshot(run=make_run(revision=2, curves={"rollout/ep_rew_mean": longer}))
    panel.update(more, 0.5)
    assert len(chart.data[0]) == len(first[0])
    panel.update(more, 1.1)
    assert len(chart.data[0]) == 300


def test_without_a_run_it_says_what_will_come(context, make_snapshot):
    panel = TrainingPanel(context)
    panel.update(make_snapshot(run=None), 0.0)
    assert "Curves appear here" in panel.text.content
    assert not any(chart.visible for _, chart in panel.charts)
