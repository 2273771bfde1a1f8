import shutil
import sqlite3
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from singulate.exceptions import RunError
from singulate.runs import RunDirectory, RunReader, RunRecord


def test_before_anything_is_recorded(run_dir: Path) -> None:
    reader = RunReader(run_dir)
    assert reader.count_pushes() == 0
    assert reader.last_step() == 0
    assert reader.revision() == 0
    assert reader.metric_names() == []
    assert len(reader.metrics_since("loss").steps) == 0
    assert reader.starts(0, 100).shape == (0, 2)
    assert reader.starts_since().positions.shape == (0, 2)
    assert reader.push(1) is None
    assert reader.last_pushes(5) == []
    (run_dir / "record.sqlite").touch()
    assert reader.count_pushes() == 0


def test_a_push_comes_back_bit_for_bit(run_dir: Path, make_push) -> None:
    pushes = [make_push(1), make_push(2, predicted=None, is_success=True, outcome="success")]
    with RunRecord(run_dir) as record:
        for push in pushes:
            record.add_push(push)
    reader = RunReader(run_dir)
    assert reader.push(1) == make_push(1, push_id=1)
    assert reader.last_pushes(1) == [
        make_push(2, push_id=2, predicted=None, is_success=True, outcome="success")
    ]
    assert [push.step for push in reader.pushes_since(1)] == [2]


def test_starts_of_a_window(run_dir: Path, make_push) -> None:
    with RunRecord(run_dir) as record:
        for step in range(1, 11):
            record.add_push(make_push(step))
    reader = RunReader(run_dir)
    starts = reader.starts(3, 5)
    assert starts.dtype == np.float32
    np.testing.assert_allclose(starts, [[0.3, -0.3], [0.4, -0.3], [0.5, -0.3]], rtol=1e-6)
    np.testing.assert_allclose(reader.starts(3, 5, limit=2), starts[1:])
    since = reader.starts_since(8)
    assert since.ids.tolist() == [9, 10]
    assert since.steps.tolist() == [9, 10]
    assert since.positions.dtype == np.float32


def test_pushes_of_one_step_are_all_seen(run_dir: Path, make_push) -> None:
    """Vector environments push several times in one training step."""
    reader = RunReader(run_dir)
    with RunRecord(run_dir) as record:
        record.add_push(make_push(4))
        record.flush()
        last = int(reader.starts_since().ids[-1])
        record.add_push(make_push(4))
        record.add_push(make_push(8))
    assert reader.starts_since(last).ids.tolist() == [2, 3]


def test_metrics_by_name(run_dir: Path) -> None:
    with RunRecord(run_dir) as record:
        for step in (10, 20, 30):
            record.add_metrics(step, {"loss": 1.0 / step, "reward": float(step)})
    reader = RunReader(run_dir)
    assert reader.metric_names() == ["loss", "reward"]
    series = reader.metrics_since("reward", 10)
    assert series.steps.tolist() == [20, 30]
    assert series.values.tolist() == [20.0, 30.0]
    assert abs(series.times[-1] - time.time()) < 60.0


def test_revision_changes_with_every_commit(run_dir: Path, make_push) -> None:
    reader = RunReader(run_dir)
    with RunRecord(run_dir) as record:
        first = reader.revision()
        assert reader.revision() == first
        record.add_push(make_push(1))
        record.flush()
        assert reader.revision() != first


def test_a_run_that_is_replaced(run_dir: Path, make_push) -> None:
    with RunRecord(run_dir) as record:
        record.add_push(make_push(1))
    reader = RunReader(run_dir)
    assert reader.count_pushes() == 1
    revision = reader.revision()
    shutil.rmtree(run_dir)
    assert reader.count_pushes() == 0
    RunDirectory(run_dir).create({})
    with RunRecord(run_dir) as record:
        record.add_push(make_push(1))
        record.add_push(make_push(2))
    assert reader.count_pushes() == 2
    assert reader.revision() != revision


def test_a_locked_file_is_an_error_not_a_hang(run_dir: Path) -> None:
    RunRecord(run_dir).close()
    writer = sqlite3.connect(run_dir / "record.sqlite", isolation_level=None)
    writer.execute("BEGIN EXCLUSIVE")
    reader = RunReader(run_dir)
    begin = time.monotonic()
    with pytest.raises(RunError, match="locked"):
        reader.count_pushes()
    assert time.monotonic() - begin < 10.0
    writer.execute("ROLLBACK")
    assert reader.count_pushes() == 0
    writer.close()


def test_reading_and_writing_at_once_from_several_threads(run_dir: Path, make_push) -> None:
    reader = RunReader(run_dir)
    counts: list[int] = []
    is_over = threading.Event()

    def watch() -> None:
        while not is_over.is_set():
            counts.append(reader.count_pushes())
            assert len(reader.starts(0, 1000)) >= counts[-1]

    threads = [threading.Thread(target=watch) for _ in range(3)]
    with RunRecord(run_dir) as record:
        for thread in threads:
            thread.start()
        for step in range(1, 61):
            record.add_push(make_push(step))
            record.flush()
            time.sleep(0.005)
    is_over.set()
    for thread in threads:
        thread.join()
    assert reader.count_pushes() == 60
    assert len(counts) > 10
