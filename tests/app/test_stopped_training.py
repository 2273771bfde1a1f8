"""What is said about a training that is stopped together with the dashboard."""

from app.__main__ import tell_stopped
from app.commands import StartTraining
from singulate import load_policy


def test_the_run_that_was_stopped_is_named_with_the_way_to_continue(make_bench, capsys):
    bench = make_bench()
    bench.do(StartTraining("dqn", "fixed-2", 1_000_000, 0))
    bench.until(lambda s: s.run is not None and s.run.num_steps > 0)
    stopped = bench.laboratory.close()
    assert str(stopped) == bench.snapshot.run.run_dir
    tell_stopped(stopped)
    (line,) = capsys.readouterr().err.splitlines()
    assert stopped.name in line and line.endswith(f"singulate train --resume {stopped}")
    assert load_policy(stopped).kind == "dqn"


def test_nothing_is_said_where_nothing_was_trained(make_bench, capsys):
    tell_stopped(make_bench().laboratory.close())
    assert capsys.readouterr().err == ""
