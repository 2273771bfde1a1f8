import argparse
import json
from pathlib import Path

import pytest

from singulate.bench import BenchOptions, Measurement, describe_machine
from singulate.bench.env import bench_env
from singulate.bench.growth import bench_growth
from singulate.bench.peers import PeerSpec
from singulate.bench.results import read_results
from singulate.bench.rewardmap import bench_rewardmap
from singulate.cli import main
from singulate.cli.bench import add_parser
from singulate.exceptions import InvalidValueError

SHORT = BenchOptions(seconds=0.3, num_repeats=1, num_workers=2)
PENDULUM = PeerSpec("gymnasium", "gymnasium", "Pendulum-v1", (), False, "a step of a pendulum")
"""A peer that every machine has."""


def run(*arguments: str) -> int:
    parser = argparse.ArgumentParser()
    add_parser(parser.add_subparsers())
    args = parser.parse_args(["bench", *arguments])
    status: int = args.run(args)
    return status


@pytest.fixture(scope="module")
def measured() -> dict[str, Measurement]:
    """`bench env` with peers that work, are missing, and are broken."""
    missing = PeerSpec("no", "no_such_module", "No-v0", (), False, "nothing", "pip install no")
    broken = PeerSpec("gymnasium", "gymnasium", "No-v0", (), False, "nothing")
    peers = {"Pendulum": PENDULUM, "Missing": missing, "Broken": broken}
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr("singulate.bench.env.PEERS", peers)
        found = list(bench_env(SHORT))
    by_name = {m.name: m for m in found}
    assert len(by_name) == len(found)
    return by_name


def test_fast_and_plain_pushes_take_turns_with_one_and_two_workers(
    measured: dict[str, Measurement],
) -> None:
    for kind in ("random pushes", "touching pushes"):
        for workers in ("1 worker", "2 workers"):
            fast, plain, gain = (
                measured[f"{kind}, {how}, {workers}"].value for how in ("fast", "plain", "gain")
            )
            assert fast and plain and gain == fast / plain
    random, touching = (
        measured[f"{kind} pushes, fast, 1 worker"].value for kind in ("random", "touching")
    )
    assert random and touching and random > touching
    assert (measured["random pushes, gain, 1 worker"].value or 0.0) > 1.2


def test_parts_add_up_to_a_touching_push(measured: dict[str, Measurement]) -> None:
    parts = [measured[f"touching push, {p}"] for p in ("physics", "image", "perception", "rest")]
    assert all(part.value and part.value > 0.0 for part in parts)
    assert 98 <= sum(int(part.note.split("%")[0]) for part in parts) <= 102
    solver, physics = measured["touching push, solver"], parts[0]
    assert solver.value and physics.value and 0.0 < solver.value < physics.value
    assert int(solver.note.split(": ")[1].split()[0]) > 20


def test_peers_are_measured_where_they_are_installed(measured: dict[str, Measurement]) -> None:
    steps, simulated = measured["Pendulum"], measured["Pendulum, simulated time"]
    assert steps.value and simulated.value == pytest.approx(steps.value / 30)
    assert steps.note.startswith("gymnasium 1.")
    assert measured["Missing"].value is None
    assert measured["Missing"].note == "not installed: pip install no"
    assert measured["Broken"].value is None
    assert measured["Broken"].note.startswith("does not start: ")
    assert "No" in measured["Broken"].note


def test_memory_is_that_of_the_workers(measured: dict[str, Measurement]) -> None:
    ours, theirs = measured["peak memory"], measured["Pendulum, peak memory"]
    assert ours.unit == "MiB"
    assert ours.value and theirs.value and 1000.0 > ours.value > theirs.value > 10.0


@pytest.mark.parametrize("name", ["PandaPush, small", "PushT"])
def test_the_real_peers_run(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from singulate.bench.peers import PEERS

    if not PEERS[name].is_installed:
        pytest.skip(f"needs {PEERS[name].install}")
    monkeypatch.setattr("singulate.bench.env.PEERS", {name: PEERS[name]})
    found = {m.name: m for m in bench_env(BenchOptions(seconds=0.01, num_workers=1))}
    assert (found[name].value or 0.0) > 0.1
    expected = 0.04 if name.startswith("Panda") else 0.1
    assert found[f"{name}, simulated time"].value == pytest.approx(
        expected * (found[name].value or 0.0)
    )


def test_coarse_map_comes_before_the_full_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("singulate.bench.rewardmap.RESOLUTION", 20)
    monkeypatch.setattr("singulate.bench.rewardmap._NUM_PLAIN_PUSHES", 30)
    found = {m.name: m.value or 0.0 for m in bench_rewardmap(SHORT)}
    assert 0.0 < found["coarse map, 8 x 8"] < found["coarse map, 16 x 16"]
    assert found["coarse map, 16 x 16"] < found["full map, 20 x 20"]
    assert found["full map, gain"] > 10.0
    assert found["peak memory"] > 10.0


def test_growth_is_measured_along_each_axis(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("singulate.bench.growth.NUM_BLOCKS", (2, 3))
    monkeypatch.setattr("singulate.bench.growth.RESOLUTIONS", (8, 12))
    monkeypatch.setattr("singulate.bench.growth._USUAL_RESOLUTION", 8)
    curves: dict[tuple[str, str], list[Measurement]] = {}
    for point in bench_growth(SHORT):
        curves.setdefault((point.axis, point.name), []).append(point)
    assert curves.pop(("", "peak memory"))
    assert {key: [point.at for point in points] for key, points in curves.items()} == {
        ("blocks", "reward map"): [2, 3],
        ("pixels", "reward map"): [8, 12],
        ("workers", "reward map"): [1, 2],
        ("blocks", "touching pushes"): [2, 3],
        ("workers", "touching pushes"): [1, 2],
    }
    assert all(point.value for points in curves.values() for point in points)


def test_machine_readable_output_names_the_machine(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("singulate.bench.env.PEERS", {})
    out = tmp_path / "bench.json"
    assert run("env", "--seconds", "0.05", "--workers", "1", "--json", "--out", str(out)) == 0
    output = json.loads(capsys.readouterr().out)
    assert output == json.loads(out.read_text())
    assert output["machine"]["num_cores"] == describe_machine()["num_cores"]
    assert output["machine"]["pybullet"]
    assert output["benchmarks"]["env"][0]["unit"] == "pushes/s"
    assert output["seconds"]["env"] > 0.0
    assert read_results(out).benchmarks["env"][0].name == "random pushes, fast, 1 worker"


def test_what_was_measured_before_a_benchmark_broke_off_is_printed(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("singulate.bench.env.PEERS", {})
    monkeypatch.setenv("PATH", str(tmp_path))  # no browser here
    arguments = ["env", "dashboard", "--seconds", "0.05", "--workers", "1", "--json"]
    assert main(["bench", *arguments]) == 2
    printed = capsys.readouterr()
    assert printed.err.startswith("singulate: error: bench dashboard needs a browser")
    found = tmp_path / "bench.json"
    found.write_text(printed.out)
    results = read_results(found)
    assert results.benchmarks["env"] and not results.benchmarks["dashboard"]
    assert main(["bench", "--read", str(found)]) == 0


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["fps"], "benchmark"),
        (["--seconds", "nan"], "seconds"),
        (["--repeats", "0"], "repeats"),
        (["rewardmap", "--workers", "0"], "workers"),
        (["--plot", "curves.pdf"], "plot"),
        (["--out", "/nowhere/bench.json"], "out"),
        (["--read", "pyproject.toml"], "read"),
    ],
)
def test_bad_values_are_refused(arguments: list[str], key: str) -> None:
    with pytest.raises(InvalidValueError, match=f"^{key}: "):
        run(*arguments)


def test_a_file_that_is_not_there_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--read", "nowhere.json"]) == 2
    assert capsys.readouterr().err == "singulate: error: nowhere.json: No such file or directory\n"
