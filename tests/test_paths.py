from pathlib import Path

import pytest

import singulate.paths
from singulate.paths import default_runs_directory, shipped_checkpoints_directory


def test_runs_directory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SINGULATE_RUNS", raising=False)
    assert default_runs_directory() == Path("runs")
    monkeypatch.setenv("SINGULATE_RUNS", "/data/runs")
    assert default_runs_directory() == Path("/data/runs")


def test_shipped_checkpoints_lie_beside_the_package() -> None:
    root = Path(singulate.paths.__file__).parents[1]
    assert shipped_checkpoints_directory() == root / "checkpoints"
