import csv
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from pathlib import Path

import pytest
from arro3.io import read_parquet
from PIL import Image

from singulate.checkpoints.durable import replace_file
from singulate.cli import main
from singulate.engine import Engine, LocalEngine
from singulate.exceptions import CheckpointError, RunError
from singulate.experiments.cell import Cell, CellTask, run_cell
from singulate.experiments.cell_store import CellStore
from singulate.experiments.grid import make_cells
from singulate.experiments.run_cells import run_cells
from singulate.runs import RunDirectory, RunReader
from singulate.training.trainer import train

SMALL = ("--set", "learning_starts=5", "--set", "batch_size=8", "--set", "net_arch=[8]")
SWEEP = ("sweep", "--scenarios", "fixed-2", "--episodes", "6", *SMALL)


OpenEngine = Callable[[], AbstractContextManager[Engine]]


@pytest.fixture(scope="module")
def open_engine() -> Iterator[OpenEngine]:
    """One engine for all tests: loading torch takes its worker seconds."""
    with LocalEngine(num_workers=1, niceness=0) as engine:
        yield lambda: nullcontext(engine)


def small_cells(steps: int, num_seeds: int) -> list[Cell]:
    settings = {"learning_starts": 5, "batch_size": 8, "net_arch": [8]}
    return make_cells(["dqn"], ["fixed-2"], [settings], range(num_seeds), steps=steps, episodes=5)


def test_a_sweep_is_computed_once_and_written_in_every_form(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    grid = ["--seeds", "0,1", "--vary", "learning_rate=[0.001,0.01]", "--steps", "20"]
    command = [*SWEEP, *grid, "--out", str(tmp_path), "--workers", "1", "--json"]
    assert main(command) == 0
    first = json.loads(capsys.readouterr().out)
    assert first["num_computed"] == 4
    assert len({row["weights_sha256"] for row in first["rows"]}) == 4
    assert [group["num_seeds"] for group in first["pooled"]] == [2, 2]

    table = (tmp_path / "results.csv").read_bytes()
    rows = list(csv.DictReader(table.decode().splitlines()))
    parquet = read_parquet(str(tmp_path / "results.parquet")).read_all()
    assert parquet.column_names == list(rows[0])
    assert [value.as_py() for value in parquet["weights_sha256"]] == [
        row["weights_sha256"] for row in rows
    ]
    assert all(float(r["success_low"]) <= float(r["success_rate"]) for r in rows)
    with Image.open(tmp_path / "results.png") as picture:
        assert picture.width > 1000

    assert main(command) == 0
    assert json.loads(capsys.readouterr().out) == first | {"num_computed": 0}
    assert (tmp_path / "results.csv").read_bytes() == table


def test_a_killed_sweep_goes_on_and_ends_as_if_nothing_had_happened(
    tmp_path: Path, open_engine: OpenEngine
) -> None:
    cells = small_cells(steps=400, num_seeds=1)
    store = CellStore(tmp_path / "killed" / "cells")
    command = [
        *(sys.executable, "-m", "singulate", *SWEEP, "--steps", "400", "--seeds", "0"),
        *("--workers", "1", "--out", str(tmp_path / "killed"), "--episodes", "5"),
    ]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as sweep:
        deadline = time.monotonic() + 60.0
        while RunReader(store.run_dir(cells[0])).last_step() < 50:
            assert time.monotonic() < deadline and sweep.poll() is None
            time.sleep(0.05)
        os.kill(sweep.pid, signal.SIGKILL)
    assert store.read(cells[0]) is None
    outcome = run_cells(cells, store, open_engine)
    untouched = run_cells(cells, CellStore(tmp_path / "untouched"), open_engine)
    assert outcome.num_computed == 1
    assert outcome.results == untouched.results


def test_a_finished_training_without_a_result_is_only_evaluated(
    tmp_path: Path, open_engine: OpenEngine
) -> None:
    cells, store = small_cells(steps=20, num_seeds=1), CellStore(tmp_path)
    first = run_cells(cells, store, open_engine)
    (tmp_path / cells[0].name / "result.json").unlink()
    config = store.run_dir(cells[0]) / "config.json"
    before = (store.run_dir(cells[0]) / "checkpoints" / "step-000000020").stat().st_mtime_ns
    again = run_cells(cells, store, open_engine)
    assert again.results == first.results
    assert config.exists()
    after = (store.run_dir(cells[0]) / "checkpoints" / "step-000000020").stat().st_mtime_ns
    assert after == before


def test_a_damaged_result_and_a_run_without_checkpoints_start_over(
    tmp_path: Path, open_engine: OpenEngine
) -> None:
    cells, store = small_cells(steps=20, num_seeds=1), CellStore(tmp_path)
    first = run_cells(cells, store, open_engine)
    (tmp_path / cells[0].name / "result.json").write_text('{"key": "')
    for checkpoint in (store.run_dir(cells[0]) / "checkpoints").iterdir():
        (checkpoint / "manifest.json").write_text("{}")
    assert run_cells(cells, store, open_engine).results == first.results


def test_a_failed_cell_is_reported_and_the_others_finish(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cells = small_cells(steps=20, num_seeds=2)
    run_dir = CellStore(tmp_path / "cells").run_dir(cells[0])
    run_dir.parent.mkdir(parents=True)
    run_dir.write_text("in the way")
    options = ["--steps", "20", "--seeds", "0,1", "--episodes", "5", "--workers", "1"]
    assert main([*SWEEP, *options, "--out", str(tmp_path), "--json"]) == 2
    captured = capsys.readouterr()
    assert [row["seed"] for row in json.loads(captured.out)["rows"]] == [1]
    assert f"error: {cells[0].name}: " in captured.err
    assert captured.err.count("\n") == 1


def test_settings_reach_their_owner_and_equal_cells_are_one() -> None:
    settings = [
        {"dqn.learning_rate": 0.01, "env.reward": "separation"},
        {"dqn.learning_rate": 0.02, "env.reward": "separation"},
    ]
    cells = make_cells(["dqn", "ppo"], ["fixed-2"], settings, [0], steps=10)
    assert [cell.training.agent for cell in cells] == ["dqn", "dqn", "ppo"]
    assert [cell.training.agent_config["learning_rate"] for cell in cells][:2] == [0.01, 0.02]
    assert {cell.training.env.reward for cell in cells} == {"separation"}
    assert "dqn.learning_rate" not in cells[2].settings


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--agents", "a2c"], "agent: 'a2c' is not allowed"),
        (["--agents", "dqn,"], "agents: 'dqn,' is not allowed"),
        (["--scenarios", "random-99"], "scenario: 'random-99' is not allowed"),
        (["--seeds", "4-2"], "seeds: '4-2' is not allowed"),
        (["--vary", "learning_rate=0.1"], "--vary: 'learning_rate=0.1' is not allowed"),
        (["--set", "net_arch=[4]"], "'net_arch' is not allowed; allowed: each setting once"),
        (["--vary", "batch_size=[4]"], "'batch_size' is not allowed; allowed: each setting once"),
        (["--vary", 'env.scenario=["random-2"]'], "--scenarios for this one"),
        (["--set", "ppo.n_steps=8"], "settings of env or of this sweep's agents, dqn"),
        (["--set", "colour=1"], "colour"),
        (["--set", "env.colour=1"], "colour"),
        (["--steps", "0"], "steps: 0 is not allowed"),
        (["--episodes", "0"], "episodes: 0 is not allowed"),
        (["--out", "/proc/sweep"], "out: '/proc/sweep' is not allowed"),
    ],
)
def test_bad_options_are_one_line_and_nothing_is_trained(
    options: list[str], text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*SWEEP, "--out", str(tmp_path), *options]) == 2
    error = capsys.readouterr().err
    assert text in error
    assert error.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("at", "error", "last"), [(40, RunError, 20), (60, CheckpointError, 40)])
def test_a_checkpoint_that_cannot_be_written_ends_the_cell_and_costs_no_earlier_one(
    at: int, error: type[Exception], last: int, tmp_path: Path
) -> None:
    (small,) = small_cells(60, 1)
    cell = replace(small, training=replace(small.training, checkpoint_every=40))
    task = CellTask(cell, str(tmp_path / "run"))
    interrupted = replace(cell.training, total_timesteps=20)
    train(interrupted, tmp_path / "run")
    run = RunDirectory(tmp_path / "run")
    replace_file(run.config_path, json.dumps(cell.training.to_dict()).encode())
    foreign = run.checkpoint_path(at)
    foreign.mkdir()
    (foreign / "notes.txt").touch()
    with pytest.raises(error, match="is not a checkpoint"):
        run_cell(None, task)
    assert run.latest_checkpoint() == run.checkpoint_path(last)
    (foreign / "notes.txt").unlink()
    foreign.rmdir()
    assert run_cell(None, task).num_steps == 60
