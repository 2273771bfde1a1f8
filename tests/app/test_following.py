"""Whose policy is on the page while runs are trained: the last one that somebody asked for."""

import pytest

from app.commands import LoadPolicy, PauseTraining, StartTraining, WatchRun

TRAINING = StartTraining("dqn", "fixed-2", 1_000_000, 0, {"checkpoint_every": 20})


@pytest.fixture
def bench(make_bench):
    """A laboratory that trains, and follows what it trains."""
    bench = make_bench()
    bench.do(TRAINING)
    bench.until(lambda s: s.policy is not None and s.policy.is_live)
    return bench


def chosen(bench, source):
    bench.do(LoadPolicy(str(source)))
    bench.until(lambda s: s.policy.source == str(source))


def test_a_policy_that_is_chosen_stays_while_the_run_goes_on(bench, untrained):
    chosen(bench, untrained / "ppo-untrained")
    before = bench.snapshot.run.last_checkpoint
    bench.until(lambda s: s.run.last_checkpoint != before)
    policies = [s.policy for s in bench.run(0.5)]
    assert {(p.source, p.is_live) for p in policies} == {(str(untrained / "ppo-untrained"), False)}
    bench.do(LoadPolicy("run"))
    bench.until(lambda s: s.policy.is_live)
    newest = bench.snapshot.policy.num_steps
    bench.until(lambda s: s.policy.num_steps > newest)


def test_a_refused_start_leaves_the_chosen_policy_alone(bench, make_bench, untrained):
    chosen(bench, untrained / "dqn-untrained")
    bench.do(TRAINING)
    bench.until(lambda s: any("still training" in text for text in bench.texts))
    other = make_bench()
    other.do(TRAINING)
    run = other.until(lambda s: s.run is not None and s.run.last_checkpoint).run
    other.do(PauseTraining())
    bench.do(WatchRun(run.run_dir))
    bench.until(lambda s: s.run.run_dir == run.run_dir and s.run.last_checkpoint)
    bench.run(0.5)
    assert bench.snapshot.policy.source == str(untrained / "dqn-untrained")
