import argparse
import json
from pathlib import Path

import numpy as np
import pytest

from singulate.cli.rewardmap import add_parser
from singulate.exceptions import InvalidValueError


def run(*arguments: str) -> int:
    parser = argparse.ArgumentParser()
    add_parser(parser.add_subparsers())
    args = parser.parse_args(["rewardmap", *arguments])
    status: int = args.run(args)
    return status


def test_the_map_is_written_and_described(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "map.npz"
    arguments = ["--scenario", "random-2", "--seed", "5", "--resolution", "8", "--out", str(out)]
    assert run(*arguments, "--json") == 0
    described = json.loads(capsys.readouterr().out)
    with np.load(out, allow_pickle=False) as data:
        values = data["reward_map"]
    assert values.shape == (4, 8, 8)
    assert values.dtype == np.float32
    assert [best["direction"] for best in described["best"]] == ["up", "right", "down", "left"]
    assert described["best"][0]["reward"] == pytest.approx(values[0].max(), abs=1e-3)


def test_people_get_lines_and_a_bar(capsys: pytest.CaptureFixture[str]) -> None:
    assert run("--resolution", "4", "--workers", "1") == 0
    captured = capsys.readouterr()
    assert "best push    up" in captured.out
    assert "4 x 4 starts" in captured.err


@pytest.mark.parametrize(
    ("arguments", "key"),
    [
        (["--scenario", "random-99"], "scenario"),
        (["--seed", "-1"], "seed"),
        (["--resolution", "0"], "resolution"),
        (["--reward", "gold"], "reward"),
        (["--goal-separation", "nan"], "goal_separation"),
        (["--workers", "0"], "num_workers"),
        (["--out", "/no/such/directory/map.npz"], "out"),
        (["--out", "/proc/map.npz"], "out: '/proc/map.npz' is not allowed; .* can be written"),
        (["--out", "/dev/full"], "a file, this is a device or a pipe"),
        (["--out", "/"], "out: '/' is not allowed; allowed: a file, this is a directory"),
    ],
)
def test_bad_values_are_refused_before_any_work(arguments: list[str], key: str) -> None:
    with pytest.raises(InvalidValueError, match=key):
        run(*arguments)
