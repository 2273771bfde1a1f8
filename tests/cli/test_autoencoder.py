import json
from pathlib import Path

import pytest

from singulate.cli import main

SMALL = ("--scenes", "8", "--updates", "4", "--unseen", "5")


def test_it_is_trained_measured_and_saved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = str(tmp_path / "ae")
    assert main(["autoencoder", *SMALL, "--out", out, "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["out"], result["num_scenes"]) == (out, 5)
    assert result["mean_absolute_error_px"] > 0.0
    assert sorted(path.name for path in Path(out).iterdir()) == [
        "manifest.json",
        "weights.safetensors",
    ]
    weights = (tmp_path / "ae" / "weights.safetensors").read_bytes()
    assert main(["autoencoder", *SMALL, "--out", out]) == 2
    assert "--overwrite" in capsys.readouterr().err
    assert main(["autoencoder", *SMALL, "--out", out, "--overwrite"]) == 0
    assert "5 unseen scenes" in capsys.readouterr().out
    assert (tmp_path / "ae" / "weights.safetensors").read_bytes() == weights


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--scenes", "0"), "scenes: 0"),
        (("--updates", "0"), "updates: 0"),
        (("--unseen", "0"), "unseen: 0"),
        (("--threads", "0"), "threads: 0"),
        (("--seed", "-1"), "seed: -1"),
        (("--scenario", "moon-2"), "moon-2"),
        (("--out", "{file}"), "is there already and is not a checkpoint"),
    ],
)
def test_bad_options_are_one_line(
    options: tuple[str, str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "file"
    file.write_text("mine")
    given = [option.format(file=file) for option in options]
    assert main(["autoencoder", *SMALL, "--out", str(tmp_path / "ae"), *given]) == 2
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_an_autoencoder_is_no_agent(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = str(tmp_path / "ae")
    assert main(["autoencoder", *SMALL, "--out", out]) == 0
    capsys.readouterr()
    assert main(["evaluate", out, "--episodes", "1"]) == 2
    error = capsys.readouterr().err
    assert "'autoencoder' is not allowed" in error and error.count("\n") == 1
