import os
from pathlib import Path

from singulate.runs import RunDirectory, list_runs


def test_runs_newest_first_with_the_damaged_ones(tmp_path: Path) -> None:
    for age, name in enumerate(("new", "middle", "old")):
        run = RunDirectory(tmp_path / name).create({"agent": name})
        os.utime(run.config_path, (1e9 - age, 1e9 - age))
    (tmp_path / "middle" / "status.json").write_text("{")
    (tmp_path / "not a run").mkdir()
    (tmp_path / "file").touch()
    RunDirectory(tmp_path / ".old.0123.deleted").create({"agent": "left over"})
    summaries = list_runs(tmp_path)
    assert [summary.name for summary in summaries] == ["new", "middle", "old"]
    assert [summary.status is None for summary in summaries] == [False, True, False]
    assert "status.json: cannot be read" in summaries[1].problem
    assert summaries[1].config == {"agent": "middle"}


def test_no_directory(tmp_path: Path) -> None:
    assert list_runs(tmp_path / "nowhere") == []
