from app.panels.status_text import age_text, progress_text


def test_a_running_run_tells_its_speed_and_the_time_left(make_run):
    run = make_run()
    assert progress_text(run) == "1,000 / 4,000 pushes · 200/s"
    assert age_text(run) == "15 s left · updated just now"


def test_a_quiet_trainer_is_seen_by_its_age(make_run):
    assert age_text(make_run(age_s=75.0)) == "15 s left · updated 1 min 15 s ago"


def test_a_stopped_run_tells_neither_speed_nor_time_left(make_run):
    run = make_run(state="stopped", age_s=7200.0)
    assert progress_text(run) == "1,000 / 4,000 pushes"
    assert age_text(run) == "updated 2 h 0 min ago"
