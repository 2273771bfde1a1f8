"""A small sample of `singulate exactness`; the full report is committed in docs/exactness.json."""

import json
from pathlib import Path

import numpy as np
import pytest

from singulate.cli import main
from singulate.experiments.agreement import started_further_back
from singulate.experiments.exactness import compare_maps, compare_pushes
from singulate.geometry import Direction, Push


def test_fast_pushes_agree_with_plain_ones_as_well_as_plain_ones_do() -> None:
    report = compare_pushes(60, np.random.default_rng(0))
    fast, yardstick = report["fast"], report["yardstick"]
    assert fast["num_pushes"] == yardstick["num_pushes"] == 60
    assert fast["displacement_mm"]["0.5"] <= yardstick["displacement_mm"]["0.5"] + 0.2
    assert fast["displacement_mm"]["0.9"] <= yardstick["displacement_mm"]["0.9"] + 20.0
    assert fast["success_agreement"] >= 0.95


def test_shared_trajectories_agree_with_plain_pushes() -> None:
    report = compare_maps(1, np.random.default_rng(0), num_lines=6)
    shared, yardstick = report["shared"], report["yardstick"]
    assert shared["num_pushes"] > 30
    assert shared["success_agreement"] >= yardstick["success_agreement"] - 0.05
    assert shared["reward_error"]["0.5"] == 0.0


def test_the_yardstick_ends_where_the_push_ends() -> None:
    push = Push.cardinal((0.1, 0.2), Direction.LEFT, 0.5)
    back = started_further_back(push)
    assert back.end == pytest.approx(push.end)
    assert back.start == pytest.approx((0.101, 0.2))


def test_the_command_writes_its_report(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "report.json"
    sizes = ["--pushes", "3", "--scenes", "1"]
    assert main(["exactness", *sizes, "--json", "--out", str(out)]) == 0
    report = json.loads(out.read_text())
    assert report == json.loads(capsys.readouterr().out)
    assert report["pushes"]["fast"]["num_pushes"] == 3


def test_people_get_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["exactness", "--pushes", "2", "--scenes", "1"]) == 0
    assert "reward maps: shared" in capsys.readouterr().out


@pytest.mark.parametrize("option", ["pushes", "scenes"])
def test_numbers_out_of_range_are_refused(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["exactness", f"--{option}", "0"]) == 2
    assert f"{option}: 0 is not allowed" in capsys.readouterr().err
