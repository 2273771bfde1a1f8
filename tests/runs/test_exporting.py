import csv
from pathlib import Path

import pytest

from singulate.exceptions import RunError
from singulate.runs import RunRecord, export_run
from singulate.runs.push_record import poses_from_json


def test_csv_files_hold_everything(run_dir: Path, tmp_path: Path, make_push) -> None:
    with RunRecord(run_dir) as record:
        for step in (1, 2, 3):
            record.add_push(make_push(step))
            record.add_metrics(step, {"loss": 0.1 * step})
        record.flush()
        paths = export_run(run_dir, tmp_path / "out")
    assert [path.name for path in paths] == ["metrics.csv", "pushes.csv"]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "metrics.csv",
        "pushes.csv",
    ]
    with paths[0].open(newline="") as file:
        metrics = list(csv.DictReader(file))
    assert [(row["name"], row["step"], float(row["value"])) for row in metrics] == [
        ("loss", "1", 0.1),
        ("loss", "2", 0.2),
        ("loss", "3", 0.1 * 3),
    ]
    with paths[1].open(newline="") as file:
        pushes = list(csv.DictReader(file))
    assert [row["id"] for row in pushes] == ["1", "2", "3"]
    assert float(pushes[0]["r_start"]) == 1.0 / 3.0
    assert pushes[0]["outcome"] == "not_separated"
    assert poses_from_json(pushes[0]["poses"]) == make_push(1).poses


def test_an_empty_run_gives_headers(run_dir: Path, tmp_path: Path) -> None:
    paths = export_run(run_dir, tmp_path / "out")
    assert [len(path.read_text().splitlines()) for path in paths] == [1, 1]


def test_bad_places(run_dir: Path, tmp_path: Path) -> None:
    with pytest.raises(RunError, match="no such run directory"):
        export_run(tmp_path / "nowhere", tmp_path / "out")
    (tmp_path / "file").touch()
    with pytest.raises(RunError, match="cannot be written"):
        export_run(run_dir, tmp_path / "file")
