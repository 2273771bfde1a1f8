import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from singulate.exceptions import RunError
from singulate.runs import RunDirectory


def test_layout(run_dir: Path) -> None:
    run = RunDirectory(run_dir).open()
    assert run.read_config()["agent"] == "dqn"
    assert run.checkpoint_path(1000) == run_dir / "checkpoints" / "step-000001000"
    assert run.latest_checkpoint() is None
    assert sorted(path.name for path in run_dir.iterdir()) == [
        "checkpoints",
        "config.json",
        "control",
        "lock",
        "tensorboard",
    ]


def test_a_run_is_not_made_twice(run_dir: Path) -> None:
    with pytest.raises(RunError, match="holds a run already"):
        RunDirectory(run_dir).create({})


def test_a_directory_with_other_things_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "photo.jpg").touch()
    with pytest.raises(RunError, match=r"is not empty, it holds 'photo\.jpg'"):
        RunDirectory(tmp_path).create({})
    assert [path.name for path in tmp_path.iterdir()] == ["photo.jpg"]


def test_the_log_of_a_trainer_that_is_starting_may_be_there(tmp_path: Path) -> None:
    (tmp_path / "trainer.log").write_text("starting")
    assert RunDirectory(tmp_path).create({"seed": 3}).is_run
    assert RunDirectory(tmp_path).open().read_config() == {"seed": 3}
    assert (tmp_path / "trainer.log").read_text() == "starting"


def test_missing_and_foreign(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="no such run directory"):
        RunDirectory(tmp_path / "nowhere").open()
    (tmp_path / "config.json").write_text("{}")
    with pytest.raises(RunError, match="not a run directory"):
        RunDirectory(tmp_path).open()


@pytest.mark.parametrize("text", ["", "{", "[]", "[" * 100_000])
def test_damaged_configuration(run_dir: Path, text: str) -> None:
    (run_dir / "config.json").write_text(text)
    with pytest.raises(RunError, match=r"config\.json: cannot be read") as caught:
        RunDirectory(run_dir).read_config()
    assert "\n" not in str(caught.value)


def test_a_file_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(RunError, match="cannot be created or written"):
        RunDirectory(tmp_path / "file" / "run").create({})


def test_configuration_that_is_not_json(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="not plain JSON"):
        RunDirectory(tmp_path / "run").create({"rate": float("nan")})
    assert not (tmp_path / "run").exists()


READ_ONLY = """
import os, sys
from pathlib import Path
from singulate.exceptions import RunError
from singulate.runs import ControlInbox, RunDirectory, RunLock, RunReader, RunRecord
from singulate.runs import read_status, send_control
parent = Path(sys.argv[1])
if os.geteuid() == 0:
    os.seteuid(65534)
run_dir = parent / "run"
for attempt in (
    lambda: RunDirectory(parent / "other").create({}),
    lambda: RunLock(run_dir).acquire(),
    lambda: RunRecord(run_dir),
    lambda: send_control(run_dir, "pause"),
):
    try:
        attempt()
    except RunError as error:
        print(error)
print(RunReader(run_dir).count_pushes(), read_status(run_dir).state)
"""


@pytest.fixture
def read_only_parent() -> Iterator[Path]:
    """A directory below which nobody but root may write, and everybody may read."""
    with tempfile.TemporaryDirectory() as name:
        parent = Path(name)
        run_dir = RunDirectory(parent / "run").create({}).path
        directories = [parent, *(path for path in run_dir.rglob("*") if path.is_dir()), run_dir]
        for path in [path for path in run_dir.iterdir() if path.is_file()]:
            path.chmod(0o444)
        for path in directories:
            path.chmod(0o555)
        yield parent
        for path in directories:
            path.chmod(0o755)


def test_a_directory_that_is_not_writable(read_only_parent: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", READ_ONLY, str(read_only_parent)],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )
    *errors, last = done.stdout.splitlines()
    assert len(errors) == 4, done.stderr
    assert all("cannot be" in line for line in errors)
    assert last == "0 starting"
