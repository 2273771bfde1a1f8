import argparse
import io
import json
from pathlib import Path

import pytest

from singulate.cli.runs import add_parser
from singulate.exceptions import RunError
from singulate.geometry import Block, Push, standing_pose
from singulate.runs import ControlInbox, PushRecord, RunDirectory, RunLock, RunRecord

CONFIG = {"agent": "dqn", "env": {"scenario": "random-2"}, "total_timesteps": 100, "seed": 0}


@pytest.fixture
def run_dir(tmp_path: Path) -> Path:
    run_dir = RunDirectory(tmp_path / "first").create(CONFIG).path
    terms = {"start": 1.0, "distance": 0.1, "inside": 0.0, "success": 1.0}
    push = Push((0.1, 0.2), (0.0, 1.0), 0.5)
    with RunRecord(run_dir) as record:
        poses = (standing_pose(Block(0.0, 0.0)),)
        record.add_push(PushRecord(1, 1, push, 1400.0, terms, True, "success", poses))
        record.add_metrics(1, {"loss": 0.5, "diverged": float("nan")})
    return run_dir


def call(*arguments: str, runs_dir: Path) -> int:
    parser = argparse.ArgumentParser()
    add_parser(parser.add_subparsers())
    args = parser.parse_args(["runs", *arguments, "--runs-dir", str(runs_dir)])
    status = args.run(args)
    assert isinstance(status, int)
    return status


def test_list(run_dir: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("list", runs_dir=run_dir.parent) == 0
    out = capsys.readouterr().out
    assert "first" in out
    assert "random-2" in out
    assert call("list", "--json", runs_dir=run_dir.parent) == 0
    (entry,) = json.loads(capsys.readouterr().out)
    assert entry["name"] == "first"
    assert entry["config"] == CONFIG
    assert entry["status"]["state"] == "starting"


def test_list_of_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("list", runs_dir=tmp_path / "nowhere") == 0
    assert "There are no runs" in capsys.readouterr().out


def test_show(run_dir: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("show", "first", runs_dir=run_dir.parent) == 0
    assert "num_pushes" in capsys.readouterr().out
    assert call("show", str(run_dir), "--json", runs_dir=run_dir / "elsewhere") == 0
    values = json.loads(capsys.readouterr().out)
    assert values["num_pushes"] == 1
    assert values["recent_success"] == 1.0
    assert values["last_metrics"] == {"diverged": None, "loss": 0.5}
    assert values["latest_checkpoint"] is None


def test_export(run_dir: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("export", "first", "--out", str(tmp_path / "csv"), runs_dir=tmp_path) == 0
    paths = [Path(line) for line in capsys.readouterr().out.splitlines()]
    assert [path.name for path in paths] == ["metrics.csv", "pushes.csv"]
    assert all(path.is_file() for path in paths)


def test_delete_asks(run_dir: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("n\n"))
    assert call("delete", "first", runs_dir=run_dir.parent) == 1
    assert run_dir.exists()
    monkeypatch.setattr("sys.stdin", io.StringIO(""))
    with pytest.raises(RunError, match="give --yes"):
        call("delete", "first", runs_dir=run_dir.parent)
    assert run_dir.exists()
    monkeypatch.setattr("sys.stdin", io.StringIO("y\n"))
    assert call("delete", "first", runs_dir=run_dir.parent) == 0
    assert not run_dir.exists()


def test_delete_refuses_a_living_run(run_dir: Path) -> None:
    with RunLock(run_dir), pytest.raises(RunError, match="in use by process"):
        call("delete", "first", "--yes", runs_dir=run_dir.parent)
    assert call("delete", "first", "--yes", runs_dir=run_dir.parent) == 0


@pytest.mark.parametrize("command", ["pause", "resume", "stop", "checkpoint"])
def test_a_running_trainer_gets_orders(
    run_dir: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with RunLock(run_dir):
        assert call(command, "first", "--json", runs_dir=run_dir.parent) == 0
    assert json.loads(capsys.readouterr().out)["sent"] == command
    assert [message.command for message in ControlInbox(run_dir).drain()] == [command]


def test_nobody_there_to_pause(run_dir: Path) -> None:
    with pytest.raises(RunError, match="no trainer is running there"):
        call("pause", "first", runs_dir=run_dir.parent)
    assert ControlInbox(run_dir).drain() == []


@pytest.mark.parametrize("action", ["show", "delete", "pause"])
def test_unknown_run(tmp_path: Path, action: str) -> None:
    with pytest.raises(RunError, match="second: no run in"):
        call(action, "second", runs_dir=tmp_path)
