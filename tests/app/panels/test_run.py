import pytest

from app.commands import PauseTraining, ResumeTraining, StartTraining
from app.panels.run import RunPanel
from singulate.exceptions import InvalidValueError


def test_without_a_run_it_offers_to_start_one(context, make_snapshot, submitted):
    panel = RunPanel(context)
    panel.update(make_snapshot(run=None, runs=()))
    assert "No training yet" in panel.status.content
    assert panel.train.label == "Start training"
    assert panel.save.disabled and panel.stop.disabled
    panel.train_or_pause()
    assert submitted == [StartTraining("spatial", "random-2", 2_000, 0)]


def test_one_button_pauses_and_resumes(context, make_snapshot, make_run, submitted):
    panel = RunPanel(context)
    panel.update(make_snapshot())
    assert panel.train.label == "Pause" and not panel.save.disabled
    panel.train_or_pause()
    panel.update(make_snapshot(run=make_run(state="pausing")))
    assert panel.train.label == "pausing…" and panel.train.disabled
    panel.train_or_pause()
    panel.update(make_snapshot(run=make_run(state="paused")))
    panel.train_or_pause()
    assert submitted == [PauseTraining(), ResumeTraining()]


def test_progress_and_state_are_shown(context, make_snapshot, make_run):
    panel = RunPanel(context)
    panel.update(make_snapshot())
    assert panel.progress.value == 25.0
    assert "running" in panel.status.content
    panel.update(make_snapshot(run=make_run(state="died", reason="killed <9>")))
    assert "killed &lt;9&gt;" in panel.status.content
    assert panel.train.label == "Resume"


def test_showing_a_state_commands_nothing(context, make_snapshot, make_run, submitted):
    panel = RunPanel(context)
    for state in ("running", "paused", "finished", "died"):
        panel.update(make_snapshot(run=make_run(state=state, run_dir=f"/runs/{state}")))
    assert submitted == []


@pytest.mark.parametrize(("field", "value"), [("steps", 0), ("seed", -1), ("scenario", "mars")])
def test_a_form_with_bad_values_starts_nothing(field, value, context, submitted):
    panel = RunPanel(context)
    getattr(panel, field)._impl.value = value
    with pytest.raises(InvalidValueError):
        panel.train_or_pause()
    assert submitted == []
