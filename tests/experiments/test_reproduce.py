import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from singulate.cli import main

QUICK = ("--quick", "--steps", "600", "--jobs", "1", "--json")


def reproduce(directory: Path, *arguments: str) -> int:
    places = ["--out", str(directory / "figures"), "--runs", str(directory / "runs")]
    return main(["reproduce", *arguments, *places])


def test_figures_are_made_once_and_then_only_drawn(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert reproduce(tmp_path, "fig1", "fig2", "fig5", *QUICK) == 0
    first = json.loads(capsys.readouterr().out)
    files = sorted((tmp_path / "figures").iterdir())
    names = [f"fig{i}.{kind}" for i in (1, 2, 5) for kind in ("json", "png")]
    assert [file.name for file in files] == names
    assert (first["num_computed"], first["unfinished"], first["claims"]) == (1, [], {})
    before = {file.name: file.read_bytes() for file in files}
    assert reproduce(tmp_path, "fig1", "fig2", "fig5", *QUICK, "--no-training") == 0
    assert json.loads(capsys.readouterr().out)["num_computed"] == 0
    assert {file.name: file.read_bytes() for file in files} == before

    numbers = json.loads(before["fig5.json"])
    assert np.shape(numbers["seeds"][0]["q_map"]) == np.shape(numbers["rewards"]) == (4, 10, 10)
    assert numbers["seeds"][0]["num_steps"] == 600
    assert np.max(numbers["rewards"]) <= 300.0  # r_Start and r_Inside alone
    scenes = json.loads(before["fig2.json"])["scenes"]
    assert np.max(scenes[1]["rewards"]) > 1000.0
    with Image.open(tmp_path / "figures" / "fig5.png") as picture:
        assert picture.width == 1400


def test_what_is_not_trained_is_neither_drawn_nor_judged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert reproduce(tmp_path, "all", *QUICK, "--no-training") == 0
    made = json.loads(capsys.readouterr().out)
    assert made["unfinished"] == ["fig3", "fig4", "fig5", "fig6", "autoencoder", "ideas"]
    assert set(made["claims"].values()) == {"not measured"}
    page = (tmp_path / "figures" / "claims.md").read_text()
    assert "none yet" in page
    ceilings = json.loads((tmp_path / "figures" / "ceilings.json").read_text())
    assert ceilings["random-2"]["num_scenes"] == 20


@pytest.mark.slow
def test_everything_quickly(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert reproduce(tmp_path, "--quick") == 0
    assert "not measured" in capsys.readouterr().out
    names = {path.name for path in (tmp_path / "figures").iterdir()}
    assert names >= {f"fig{i}.png" for i in range(1, 7)} | {
        "autoencoder.png",
        "claims.md",
        "ideas.json",
        "ideas.md",
        "ideas.png",
        "training.json",
    }


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["fig9"], "figure: 'fig9' is not allowed; allowed: fig1, fig2"),
        (["fig1", "--seeds", "4-2"], "seeds: '4-2' is not allowed"),
        (["fig1", "--steps", "5"], "steps: 5 is not allowed"),
        (["fig1", "--jobs", "1", "--workers", "1"], "--workers"),
        (["fig1", "--engine", "moon"], "engine: 'moon' is not allowed"),
    ],
)
def test_bad_options_are_one_line(
    options: list[str], text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert reproduce(tmp_path, *options) == 2
    error = capsys.readouterr().err
    assert text in error and error.count("\n") == 1


def test_published_numbers_stand_for_trainings_that_are_gone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    figures = Path(__file__).parents[2] / "static" / "figures"
    shutil.copytree(figures, tmp_path / "figures")
    assert reproduce(tmp_path, "fig4", "fig5", "--reuse", "--jobs", "1", "--json") == 0
    made = json.loads(capsys.readouterr().out)
    assert (made["num_computed"], made["unfinished"]) == (0, [])
    for name in ("fig4", "fig5"):
        assert read_json(tmp_path / "figures", name) == read_json(figures, name)
    assert not any((tmp_path / "runs").iterdir())


def test_numbers_of_other_trainings_are_not_taken(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    figures = Path(__file__).parents[2] / "static" / "figures"
    shutil.copytree(figures, tmp_path / "figures")
    other = ("--reuse", "--seeds", "5", "--no-training", "--jobs", "1", "--json")
    assert reproduce(tmp_path, "fig4", "fig5", *other) == 0
    assert json.loads(capsys.readouterr().out)["unfinished"] == ["fig4", "fig5"]


def test_seeds_that_are_published_stay_when_others_are_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    figures = Path(__file__).parents[2] / "static" / "figures"
    shutil.copytree(figures, tmp_path / "figures")
    more = ("--seeds", "0-4", "--no-training", "--jobs", "1", "--json")
    assert reproduce(tmp_path, "fig5", "fig6", *more) == 0
    assert json.loads(capsys.readouterr().out)["unfinished"] == []
    for name in ("fig5", "fig6"):
        assert read_json(tmp_path / "figures", name) == read_json(figures, name)


def test_quick_trials_leave_the_committed_figures_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["reproduce", "fig1", "--quick", "--jobs", "1"]) == 0
    assert not (tmp_path / "static").exists()
    assert (tmp_path / "runs" / "reproduce" / "quick" / "fig1.png").is_file()


def read_json(directory: Path, name: str) -> object:
    return json.loads((directory / f"{name}.json").read_text())
