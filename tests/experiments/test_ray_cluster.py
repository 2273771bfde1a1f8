"""A real cluster of several nodes on this machine, and one of them killed in the middle."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

SWEEP_ON_A_CLUSTER = """
import json, os, sys, threading, time
os.environ |= {
    "RAY_AUTH_MODE": "token",
    "RAY_AUTH_TOKEN": "0123456789abcdef" * 4,
    "RAY_USAGE_STATS_ENABLED": "0",
}
from ray.cluster_utils import Cluster
from singulate.cli import main
out, *options = sys.argv[1:]
cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
nodes = [cluster.add_node(num_cpus=1) for _ in range(2)]
cluster.wait_for_nodes()
log = {"num_nodes": len(cluster.list_all_nodes())}

def kill_a_node():
    results = os.path.join(out, "cells")
    def count():
        names = os.listdir(results) if os.path.isdir(results) else []
        return sum(os.path.exists(os.path.join(results, n, "result.json")) for n in names)
    while count() < 1:
        time.sleep(0.05)
    log["num_finished_at_the_kill"] = count()
    cluster.remove_node(nodes[0], allow_graceful=False)

threading.Thread(target=kill_a_node, daemon=True).start()
options += ["--engine", "ray", "--address", cluster.address, "--workers", "3"]
began = time.monotonic()
log["status"] = main(["sweep", "--out", out, *options])
log["seconds"] = round(time.monotonic() - began, 1)
log["num_nodes_left"] = len(cluster.list_all_nodes())
print(json.dumps(log))
"""

GRID = (
    *("--agents", "dqn,ppo", "--scenarios", "random-2", "--seeds", "0-3", "--steps", "600"),
    *("--set", "dqn.learning_starts=20", "--set", "ppo.n_steps=64", "--set", "net_arch=[16,8]"),
    *("--episodes", "40"),
)


def run(command: list[str]) -> str:
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, timeout=600)
    assert done.returncode == 0
    return done.stdout


@pytest.mark.slow
def test_a_sweep_survives_the_loss_of_a_node_and_equals_the_local_one(tmp_path: Path) -> None:
    local, cluster = tmp_path / "local", tmp_path / "cluster"
    run([sys.executable, "-m", "singulate", "sweep", *GRID, "--out", str(local)])
    output = run([sys.executable, "-c", SWEEP_ON_A_CLUSTER, str(cluster), *GRID])
    log = json.loads(output.splitlines()[-1])
    assert log["status"] == 0
    assert (log["num_nodes"], log["num_nodes_left"]) == (3, 2)
    assert 1 <= log["num_finished_at_the_kill"] < 8
    names = [path.name for path in (local / "cells").iterdir()]
    assert len(names) == 8
    assert sorted(names) == sorted(path.name for path in (cluster / "cells").iterdir())
    for table in ("results.csv", "results.parquet"):
        assert (local / table).read_bytes() == (cluster / table).read_bytes()
