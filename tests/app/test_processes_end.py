"""Nothing is left behind, and the page's server stays light."""

import json
import subprocess
import sys

import psutil
import pytest

from app.commands import PushNow
from app.laboratory import Laboratory
from singulate.exceptions import InvalidValueError, RunError
from singulate.geometry import Direction, Push

SERVER = """
import json, sys, time
from pathlib import Path
from app.commands import StartTraining
from app.laboratory import Laboratory

def main():
    laboratory = Laboratory(runs_dir=Path(sys.argv[1]), checkpoints_dir=Path(sys.argv[1]))
    laboratory.set_wanted_fields({"reward_map", "q_map"})
    laboratory.submit(StartTraining("dqn", "random-2", 1_000_000, 0))
    snapshot = laboratory.tick()
    while not (snapshot.reward_map and snapshot.run and snapshot.run.state == "running"):
        laboratory.wait(0.05)
        snapshot = laboratory.tick()
        assert not snapshot.notices, snapshot.notices
    heavy = [name for name in ("torch", "pybullet", "stable_baselines3") if name in sys.modules]
    print(json.dumps({"heavy": heavy, **laboratory.pids}), flush=True)
    if sys.stdin.readline():
        laboratory.close()

if __name__ == "__main__":
    main()
"""


@pytest.fixture
def server(tmp_path):
    script = tmp_path / "server.py"
    script.write_text(SERVER)
    process = subprocess.Popen(
        [sys.executable, str(script), str(tmp_path / "runs")],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    with process:
        assert process.stdout is not None
        pids = json.loads(process.stdout.readline())
        family = psutil.Process(process.pid).children(recursive=True)
        yield process, pids, family
        process.kill()
    psutil.wait_procs(family, timeout=20.0)
    for child in family:
        if child.is_running():
            child.kill()


def test_a_closed_laboratory_leaves_no_process_and_never_loads_physics_or_learning(server):
    process, pids, family = server
    assert pids.pop("heavy") == []
    assert {pids["scene"], pids["policy"], pids["reward_map"], pids["trainer"]} <= {
        child.pid for child in family
    }
    process.communicate("close\n", timeout=60)
    assert process.returncode == 0
    _, alive = psutil.wait_procs(family, timeout=10.0)
    assert not alive


def test_a_killed_server_takes_all_but_the_trainer_along(server):
    process, pids, family = server
    trainer = psutil.Process(pids["trainer"])
    process.kill()
    others = [child for child in family if child.pid != trainer.pid]
    _, alive = psutil.wait_procs(others, timeout=10.0)
    assert not alive
    assert trainer.is_running()
    trainer.terminate()
    trainer.wait(30)


def test_a_closed_laboratory_may_be_closed_again(make_bench):
    bench = make_bench()
    bench.do(PushNow(Push.cardinal((-0.6, 0.7), Direction.RIGHT, 0.5)))
    bench.until(lambda s: s.scene.is_pushing)
    processes = [psutil.Process(pid) for pid in bench.laboratory.pids.values() if pid]
    assert len(processes) == 2
    for _ in range(2):
        assert bench.laboratory.close() is None
    assert not any(process.is_running() for process in processes)


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"scenario": "random-99"}, InvalidValueError),
        ({"seed": -1}, InvalidValueError),
        ({"run_dir": "missing"}, RunError),
    ],
)
def test_a_bad_start_is_one_line_and_leaves_no_process(tmp_path, options, error):
    if "run_dir" in options:
        options = {"run_dir": tmp_path / options["run_dir"]}
    before = {child.pid for child in psutil.Process().children()}
    with pytest.raises(error) as caught:
        Laboratory(runs_dir=tmp_path, checkpoints_dir=tmp_path, **options)
    assert "\n" not in str(caught.value)
    left = [c for c in psutil.Process().children() if c.pid not in before]
    assert not [c for c in left if "resource_tracker" not in " ".join(c.cmdline())]
