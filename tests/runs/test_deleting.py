from pathlib import Path

import pytest

from singulate.exceptions import RunError
from singulate.runs import RunLock, delete_run


def test_a_run_is_removed_whole(run_dir: Path) -> None:
    delete_run(run_dir)
    assert list(run_dir.parent.iterdir()) == []


def test_a_living_run_is_kept(run_dir: Path) -> None:
    with RunLock(run_dir), pytest.raises(RunError, match="in use by process"):
        delete_run(run_dir)
    assert (run_dir / "config.json").exists()


def test_what_is_no_run_is_kept(tmp_path: Path, run_dir: Path) -> None:
    (tmp_path / "thesis").mkdir()
    (tmp_path / "thesis" / "config.json").touch()
    with pytest.raises(RunError, match="not a run directory"):
        delete_run(tmp_path / "thesis")
    (tmp_path / "link").symlink_to(run_dir)
    with pytest.raises(RunError, match="is a link"):
        delete_run(tmp_path / "link")
    assert (tmp_path / "thesis").exists()
    assert run_dir.exists()
