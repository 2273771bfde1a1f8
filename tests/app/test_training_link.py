"""Training from the page: started, steered, watched, followed, killed, resumed."""

import os
import shutil
import signal
import time

import numpy as np
import psutil
import pytest

from app.commands import (
    PauseTraining,
    ResumeTraining,
    SaveCheckpoint,
    StartTraining,
    StopTraining,
    WatchRun,
)
from singulate import load_policy
from singulate.runs import RunDirectory
from singulate.runs.status import RunStatus, write_status

LONG = 1_000_000


def start(agent="dqn", scenario="fixed-2", steps=LONG, **options):
    return StartTraining(agent, scenario, steps, 0, {"checkpoint_every": 40, **options})


@pytest.fixture
def make_run_dir(tmp_path):
    def make(name):
        run = RunDirectory(tmp_path / name).create({"agent": "dqn"})
        write_status(run.path, RunStatus(state="stopped", total_steps=10))
        return run.path

    return make


@pytest.fixture(scope="module")
def bench(make_bench):
    return make_bench()


def test_a_run_is_started_shown_steered_followed_killed_and_resumed(make_bench):
    bench = make_bench()
    assert bench.snapshot.run is None and bench.snapshot.runs == ()
    bench.do(start())
    run = bench.until(lambda s: s.run is not None).run
    assert (run.state, run.agent, run.scenario) == ("starting", "dqn", "fixed-2")
    run = bench.until(lambda s: s.run.num_steps > 0 and len(s.run.starts) > 5).run
    assert run.state == "running" and run.total_steps == LONG and run.age_s < 10.0
    assert len(run.starts) == len(run.start_steps)
    assert (np.diff(run.start_steps) >= 0).all() and np.abs(run.starts).max() <= 1.0
    pid = bench.laboratory.pids["trainer"]
    assert psutil.Process(pid).nice() >= 5
    bench.until(lambda s: run.run_dir in s.runs)

    more = bench.until(lambda s: len(s.run.starts) > len(run.starts) and s.run.last_checkpoint).run
    assert np.array_equal(more.starts[: len(run.starts)], run.starts)
    assert more.revision > run.revision
    curves = bench.until(lambda s: s.run.curves).run.curves
    assert all(len(c.steps) == len(c.values) > 0 for c in curves.values())

    policy = bench.until(lambda s: s.policy is not None).policy
    assert policy.is_live and policy.kind == "dqn"
    bench.until(lambda s: s.policy.num_steps > policy.num_steps)

    bench.do(PauseTraining())
    bench.until(lambda s: s.run.state in ("pausing", "paused"))
    bench.until(lambda s: s.run.state == "paused")
    steps = bench.run(1.0)[-1].run.num_steps
    assert bench.run(0.5)[-1].run.num_steps == steps
    bench.do(ResumeTraining())
    bench.until(lambda s: s.run.state == "running" and s.run.num_steps > steps)

    os.kill(pid, signal.SIGKILL)
    died = bench.until(lambda s: s.run.state == "died").run
    assert "killed by signal 9" in died.reason and "\n" not in died.reason
    load_policy(died.run_dir)
    bench.do(PauseTraining())
    bench.until(lambda s: any("resume it first" in text for text in bench.texts))

    bench.do(ResumeTraining())
    bench.until(lambda s: s.run.state == "starting")
    states = {died.state}
    bench.until(lambda s: states.add(s.run.state) or s.run.state == "running")
    assert bench.laboratory.pids["trainer"] != pid
    resumed = bench.until(lambda s: s.run.num_steps > 0 and s.run.state == "running").run
    assert resumed.run_dir == died.run_dir and not resumed.reason

    bench.do(start())
    bench.until(lambda s: any("still training" in text for text in bench.texts))
    bench.do(SaveCheckpoint(), StopTraining())
    bench.until(lambda s: s.run.state in ("stopping", "stopped"))
    stopped = bench.until(lambda s: s.run.state == "stopped").run
    assert load_policy(stopped.last_checkpoint).kind == "dqn"
    bench.until(lambda s: bench.laboratory.pids["trainer"] is None)


@pytest.mark.parametrize(
    ("command", "word"),
    [
        (start(agent="a2c"), "agent"),
        (start(scenario="random-99"), "scenario"),
        (start(steps=-5), "steps"),
        (start(steps=float("nan")), "steps"),
        (start(colour="red"), "colour"),
        (start(env={"goal_separation": float("inf")}), "goal_separation"),
        (start(env=3), "env"),
        (start(agent_config={"learning_rate": "quick"}), "learning_rate"),
        (WatchRun("/nowhere"), "no such run directory"),
    ],
)
def test_a_bad_wish_is_a_notice(bench, command, word):
    known = set(bench.texts)
    bench.do(command)
    bench.until(lambda s: set(bench.texts) - known)
    (text,) = set(bench.texts) - known
    assert word in text and "\n" not in text
    assert bench.laboratory.pids["trainer"] is None


def test_a_run_that_was_not_started_here_is_watched_and_left_alone(bench, make_bench, tmp_path):
    other = make_bench(runs_dir=tmp_path)
    other.do(start())
    run_dir = other.until(lambda s: s.run is not None and s.run.state == "running").run.run_dir
    bench.do(WatchRun(run_dir))
    bench.until(lambda s: s.run is not None and s.run.run_dir == run_dir)
    bench.until(lambda s: len(s.run.starts) > 0)
    found = make_bench(runs_dir=tmp_path)
    found.until(lambda s: s.run is not None and s.run.run_dir == run_dir)
    found.laboratory.close()
    trainer = psutil.Process(other.laboratory.pids["trainer"])
    assert trainer.is_running()
    other.laboratory.close()
    trainer.wait(30)
    stopped = bench.until(lambda s: s.run.state == "stopped").run
    assert stopped.last_checkpoint


@pytest.mark.parametrize("harm", ["delete", "damage"])
def test_a_run_that_is_lost_is_told_once_and_hides_no_other(
    make_bench, make_run_dir, tmp_path, harm
):
    lost = make_run_dir("lost")
    bench = make_bench(runs_dir=tmp_path, run_dir=lost)
    bench.until(lambda s: s.run is not None and str(lost) in s.runs)
    if harm == "delete":
        shutil.rmtree(lost)
    else:
        (lost / "status.json").write_text("{")
    bench.until(lambda s: s.run is None)
    (notice,) = bench.snapshot.notices
    assert "no longer watched" in notice.text and "\n" not in notice.text
    other = make_run_dir("other")
    bench.until(lambda s: str(other) in s.runs and "run" not in dict(s.policies).values())
    assert bench.snapshot.notices == (notice,)


def test_a_trainer_that_cannot_start_says_why(make_bench, tmp_path):
    bench = make_bench(runs_dir=tmp_path / "file" / "runs")
    (tmp_path / "file").write_text("in the way")
    bench.do(start())
    bench.until(lambda s: any("cannot be written" in text for text in bench.texts))
    assert bench.snapshot.run is None


def test_ticks_do_not_wait_for_the_disk(bench, pace):
    durations = []
    for _ in range(30):
        begin = time.perf_counter()
        bench.laboratory.tick()
        durations.append(time.perf_counter() - begin)
    assert np.median(durations) < 0.005 * pace
