import numpy as np

from app.panels.starts import StartsPanel


def test_the_histogram_follows_the_run(context, make_snapshot):
    panel = StartsPanel(context)
    panel.update(make_snapshot(), 0.0)
    assert "steps 0 to 1,000" in panel.picture.content
    assert "1,000 pushes" in panel.picture.content
    assert panel.end.visible and panel.end.max == 1000 and panel.end.value == 1000
    assert panel.strip.content.count("<img") == 6


def test_a_window_put_somewhere_stays_there(context, make_snapshot):
    panel = StartsPanel(context)
    context.preferences.window_end, context.preferences.window_size = 500, 256
    panel.update(make_snapshot(), 0.0)
    assert "steps 245 to 500" in panel.picture.content
    assert "mean (0.50, 0.50) m" in panel.picture.content
    assert panel.follow.handle.options == ("○ on", "● off")


def test_the_slider_grows_with_the_run(context, make_snapshot, make_run):
    panel = StartsPanel(context)
    panel.update(make_snapshot(), 0.0)
    longer = make_run(
        starts=np.zeros((1500, 2), np.float32), start_steps=np.arange(1, 1501), revision=2
    )
    panel.update(make_snapshot(run=longer), 1.0)
    assert panel.end.max == panel.end.value == 1500


def test_an_empty_window_is_drawn_empty(context, make_snapshot, make_run):
    panel = StartsPanel(context)
    run = make_run(start_steps=np.arange(5001, 6001, dtype=np.int64))
    context.preferences.window_end, context.preferences.window_size = 600, 256
    panel.update(make_snapshot(run=run), 0.0)
    assert "0 pushes" in panel.picture.content


def test_without_a_run_it_says_what_will_come(context, make_snapshot):
    panel = StartsPanel(context)
    panel.update(make_snapshot(), 0.0)
    panel.update(make_snapshot(run=None), 1.0)
    assert "once a run is under way" in panel.picture.content
    assert not panel.end.visible
