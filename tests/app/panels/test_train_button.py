import pytest

from app.panels.train_button import TrainButton, train_button


def test_without_a_run_it_starts_one():
    assert train_button(None) == TrainButton("Start training", "start")


@pytest.mark.parametrize(
    ("state", "label", "action"),
    [
        ("starting", "starting…", None),
        ("running", "Pause", "pause"),
        ("pausing", "pausing…", None),
        ("paused", "Resume", "resume"),
        ("stopping", "stopping…", None),
        ("stopped", "Resume", "resume"),
        ("finished", "Start training", "start"),
        ("failed", "Resume", "resume"),
        ("died", "Resume", "resume"),
    ],
)
def test_label_and_action_follow_the_state(state, label, action, make_run):
    assert train_button(make_run(state=state)) == TrainButton(label, action)
