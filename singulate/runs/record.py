"""The trainer's end of a run's record."""

import json
import math
import sqlite3
import time
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from singulate.exceptions import RunError
from singulate.rewards.terms import TERMS
from singulate.runs.push_record import PushRecord, poses_to_json
from singulate.runs.run_directory import RunDirectory
from singulate.runs.schema import (
    PUSH_COLUMNS,
    add_missing_terms,
    create_tables,
    journal_mode,
    version_problem,
)

METRICS_EVERY = 100
"""Pushes between two points of a training curve."""
COMMIT_INTERVAL_S = 0.5
LOCK_TIMEOUT_S = 5.0

INSERT_METRIC = "INSERT OR REPLACE INTO metrics (name, step, value, time) VALUES (?, ?, ?, ?)"
INSERT_PUSH = (
    f"INSERT INTO pushes ({', '.join(PUSH_COLUMNS)}) VALUES ({', '.join('?' * len(PUSH_COLUMNS))})"
)
INSERT_EVENT = "INSERT INTO events (time, kind, detail) VALUES (?, ?, ?)"

Row = tuple[Any, ...]


class RunRecord:
    """Writes metrics, pushes and events of one run; a context manager.

    Rows are kept in memory and committed together about twice a second, so that the file is locked
    for moments only and a killed trainer loses at most that much.

    Args:
        run_dir: The run's directory, locked by this process.

    Raises:
        RunError: If the record is damaged, foreign or not writable.
    """

    def __init__(self, run_dir: Path) -> None:
        self._path = RunDirectory(run_dir).record_path
        self._metrics: list[Row] = []
        self._pushes: list[Row] = []
        self._events: list[Row] = []
        self._last_commit = time.monotonic()
        try:
            self._connection = sqlite3.connect(
                self._path, timeout=LOCK_TIMEOUT_S, isolation_level=None, check_same_thread=False
            )
            self._prepare()
        except sqlite3.Error as error:
            raise RunError(f"{self._path}: cannot be opened for writing ({error})") from error

    def add_metrics(self, step: int, values: Mapping[str, float]) -> None:
        """Record values of a training step by name; a later value for the same step replaces it.

        Raises:
            RunError: If a commit was due and failed.
        """
        now = time.time()
        self._metrics += [(name, step, _number(value), now) for name, value in values.items()]
        self._commit_when_due()

    def add_push(self, record: PushRecord) -> None:
        """Record a push; steps never decrease from one push to the next.

        Raises:
            RunError: If a commit was due and failed.
        """
        self._pushes.append(_push_row(record))
        self._commit_when_due()

    def add_event(self, kind: str, **detail: Any) -> None:
        """Record something that happened (a pause, a change of settings, a checkpoint).

        Args:
            kind: What happened.
            **detail: Plain JSON values.

        Raises:
            RunError: If a commit was due and failed.
        """
        self._events.append((time.time(), kind, json.dumps(detail)))
        self._commit_when_due()

    def rewind(self, step: int) -> None:
        """Forget metrics and pushes after a step, before training continues from its checkpoint.

        Raises:
            RunError: If it cannot be written.
        """
        self.flush()
        self._write(
            [
                ("DELETE FROM metrics WHERE step > ?", [(step,)]),
                ("DELETE FROM pushes WHERE step > ?", [(step,)]),
                (INSERT_EVENT, [(time.time(), "rewound", json.dumps({"step": step}))]),
            ]
        )

    def flush(self) -> None:
        """Commit what is waiting.

        Raises:
            RunError: If the disk is full or a reader blocks the file too long; the rows are kept
                and tried again with the next commit.
        """
        self._last_commit = time.monotonic()
        if not (self._metrics or self._pushes or self._events):
            return
        self._write(
            [
                (INSERT_METRIC, self._metrics),
                (INSERT_PUSH, self._pushes),
                (INSERT_EVENT, self._events),
            ]
        )
        self._metrics, self._pushes, self._events = [], [], []

    def close(self) -> None:
        """Commit what is waiting and close the file.

        Raises:
            RunError: If the last rows could not be committed.
        """
        try:
            self.flush()
        finally:
            self._connection.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()

    def _prepare(self) -> None:
        self._connection.execute(f"PRAGMA journal_mode = {journal_mode()}")
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            if self._connection.execute("SELECT COUNT(*) FROM sqlite_master").fetchone()[0] == 0:
                create_tables(self._connection)
            problem = version_problem(self._connection)
            if problem is not None:
                raise RunError(f"{self._path}: {problem}")
            add_missing_terms(self._connection)
            self._connection.execute("COMMIT")
        except BaseException:
            self._connection.close()
            raise

    def _commit_when_due(self) -> None:
        if time.monotonic() - self._last_commit >= COMMIT_INTERVAL_S:
            self.flush()

    def _write(self, statements: list[tuple[str, list[Row]]]) -> None:
        try:
            self._connection.execute("BEGIN IMMEDIATE")
            for statement, rows in statements:
                self._connection.executemany(statement, rows)
            self._connection.execute("COMMIT")
        except sqlite3.Error as error:
            if self._connection.in_transaction:
                self._connection.execute("ROLLBACK")
            raise RunError(f"{self._path}: cannot be written ({error})") from error


def _number(value: float) -> float | None:
    """SQLite has no NaN: what is not finite is stored as NULL."""
    number = float(value)
    return number if math.isfinite(number) else None


def _push_row(record: PushRecord) -> Row:
    push = record.push
    return (
        int(record.step),
        int(record.episode),
        *(float(value) for value in (*push.start, *push.direction, push.length)),
        None if record.predicted is None else _number(record.predicted),
        float(record.reward),
        *(_number(record.terms[term]) if term in record.terms else None for term in TERMS),
        int(record.is_success),
        record.outcome,
        poses_to_json(record.poses),
    )
