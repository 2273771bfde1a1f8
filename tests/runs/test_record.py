import math
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import pytest

from singulate.exceptions import RunError
from singulate.runs import RunReader, RunRecord
from singulate.runs.record import COMMIT_INTERVAL_S
from singulate.runs.schema import journal_mode


def test_rows_are_committed_together(run_dir: Path, make_push) -> None:
    reader = RunReader(run_dir)
    with RunRecord(run_dir) as record:
        record.add_push(make_push(1))
        assert reader.count_pushes() == 0
        record.flush()
        assert reader.count_pushes() == 1
        record.add_push(make_push(2))
    assert reader.count_pushes() == 2


def test_a_commit_comes_by_itself(run_dir: Path, make_push) -> None:
    with RunRecord(run_dir) as record:
        record.add_push(make_push(1))
        time.sleep(COMMIT_INTERVAL_S)
        record.add_metrics(1, {"loss": 0.5})
        assert RunReader(run_dir).count_pushes() == 1


def test_a_later_value_of_the_same_step_replaces(run_dir: Path) -> None:
    with RunRecord(run_dir) as record:
        record.add_metrics(5, {"loss": 0.5})
        record.add_metrics(5, {"loss": 0.25, "bad": math.inf})
    reader = RunReader(run_dir)
    assert reader.metrics_since("loss").values.tolist() == [0.25]
    assert math.isnan(reader.metrics_since("bad").values[0])


def test_rewinding_forgets_what_came_after(run_dir: Path, make_push) -> None:
    reader = RunReader(run_dir)
    with RunRecord(run_dir) as record:
        for step in range(1, 11):
            record.add_push(make_push(step))
            record.add_metrics(step, {"loss": 1.0 / step})
        record.rewind(6)
        assert reader.generation() == 1
        assert reader.last_step() == 6
        assert reader.metrics_since("loss").steps.tolist() == [1, 2, 3, 4, 5, 6]
        record.add_push(make_push(7))
    assert [push.push_id for push in reader.last_pushes(2)] == [6, 7]
    assert [event.kind for event in reader.events_since()] == ["rewound"]


def test_an_existing_record_is_continued(run_dir: Path, make_push) -> None:
    for step in (1, 2):
        with RunRecord(run_dir) as record:
            record.add_push(make_push(step))
    assert RunReader(run_dir).count_pushes() == 2


def test_a_reward_term_newer_than_the_record_gets_a_column(run_dir: Path, make_push) -> None:
    RunRecord(run_dir).close()
    connection = sqlite3.connect(run_dir / "record.sqlite")
    connection.execute("ALTER TABLE pushes DROP COLUMN r_success")
    connection.close()
    with RunRecord(run_dir) as record:
        record.add_push(make_push(1))
    push = RunReader(run_dir).push(1)
    assert push is not None
    assert push.terms == make_push(1).terms


@pytest.mark.parametrize("content", [b"not a database at all" * 100, b"SQLite format 3\0" * 50])
def test_a_damaged_record(run_dir: Path, content: bytes) -> None:
    (run_dir / "record.sqlite").write_bytes(content)
    for attempt in (lambda: RunRecord(run_dir), lambda: RunReader(run_dir).count_pushes()):
        with pytest.raises(RunError, match=r"record\.sqlite: cannot be") as caught:
            attempt()
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("statement", "message"),
    [
        ("PRAGMA application_id = 5", "not a record of a run"),
        ("PRAGMA user_version = 99", "record version 99 is unknown; known: 1"),
    ],
)
def test_a_foreign_record(run_dir: Path, statement: str, message: str) -> None:
    RunRecord(run_dir).close()
    connection = sqlite3.connect(run_dir / "record.sqlite")
    connection.execute(statement)
    connection.close()
    for attempt in (lambda: RunRecord(run_dir), lambda: RunReader(run_dir).count_pushes()):
        with pytest.raises(RunError, match=message):
            attempt()


FULL_DISK = """
import resource, sys
from pathlib import Path
from singulate.exceptions import RunError
from singulate.runs import RunReader, RunRecord
run_dir = Path(sys.argv[1])
soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
with RunRecord(run_dir) as record:
    record.add_metrics(0, {"loss": 1.0})
    record.flush()
    resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, hard))
    record.add_metrics(1, {f"metric_{i:05d}": 1.0 for i in range(5000)})
    try:
        record.flush()
    except RunError as error:
        print(error)
    print(RunReader(run_dir).metric_names())
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
print(len(RunReader(run_dir).metric_names()))
"""


def test_a_full_disk_loses_nothing(run_dir: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, str(run_dir)], capture_output=True, text=True
    )
    error, names, count = done.stdout.splitlines()
    assert "record.sqlite: cannot be written" in error, done.stderr
    assert names == "['loss']"
    assert count == "5001"


@pytest.mark.parametrize(
    ("version", "mode"),
    [
        ((3, 40, 1), "DELETE"),
        ((3, 44, 5), "DELETE"),
        ((3, 44, 6), "WAL"),
        ((3, 45, 0), "DELETE"),
        ((3, 50, 7), "WAL"),
        ((3, 51, 2), "DELETE"),
        ((3, 51, 3), "WAL"),
        ((3, 52, 0), "WAL"),
    ],
)
def test_write_ahead_log_only_where_it_is_safe(version: tuple[int, int, int], mode: str) -> None:
    assert journal_mode(version) == mode
