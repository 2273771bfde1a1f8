import argparse
import json

import pytest

from singulate.bench import BenchOptions, describe_machine
from singulate.bench.env import bench_env
from singulate.bench.rewardmap import bench_rewardmap
from singulate.cli.bench import add_parser
from singulate.exceptions import InvalidValueError

WHAT = ("", ", plain", ", gain")
SHORT = BenchOptions(seconds=0.2, num_repeats=1, num_workers=2)


def run(*arguments: str) -> int:
    parser = argparse.ArgumentParser()
    add_parser(parser.add_subparsers())
    args = parser.parse_args(["bench", *arguments])
    status: int = args.run(args)
    return status


def test_env_parts_add_up_to_all_of_a_push() -> None:
    found = {m.name: m for m in bench_env(SHORT)}
    assert set(found) == {
        *(f"{kind} pushes{what}" for kind in ("uniformly random", "touching") for what in WHAT),
        "physics",
        "image",
        "perception",
    }
    assert all(m.value > 0.0 for m in found.values())
    assert found["uniformly random pushes"].value > found["touching pushes"].value
    assert found["touching pushes, gain"].value > 1.0
    shares = [int(found[part].note.split("%")[0]) for part in ("physics", "image", "perception")]
    assert 98 <= sum(shares) <= 102


def test_coarse_map_comes_before_the_full_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("singulate.bench.rewardmap.RESOLUTION", 20)
    monkeypatch.setattr("singulate.bench.rewardmap._NUM_PLAIN_PUSHES", 30)
    found = {m.name: m.value for m in bench_rewardmap(SHORT)}
    assert 0.0 < found["coarse map, 8 x 8"] < found["coarse map, 16 x 16"]
    assert found["coarse map, 16 x 16"] < found["full map, 20 x 20"]
    assert found["full map, gain"] > 10.0


def test_machine_readable_output_names_the_machine(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("env", "--seconds", "0.1", "--json") == 0
    output = json.loads(capsys.readouterr().out)
    assert output["machine"]["num_cores"] == describe_machine()["num_cores"]
    assert output["machine"]["pybullet"]
    assert output["benchmarks"]["env"][0]["unit"] == "pushes/s"


def test_people_get_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("env", "--seconds", "0.1") == 0
    assert "touching pushes" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["fps"], "benchmark"),
        (["--seconds", "nan"], "seconds"),
        (["--repeats", "0"], "repeats"),
        (["rewardmap", "--workers", "0"], "num_workers"),
    ],
)
def test_bad_values_are_refused(arguments: list[str], key: str) -> None:
    with pytest.raises(InvalidValueError, match=key):
        run(*arguments)
