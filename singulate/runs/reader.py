"""The watcher's end of a run's record."""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.exceptions import RunError
from singulate.geometry import Push
from singulate.runs.push_record import PushRecord, poses_from_json
from singulate.runs.read_connection import ReadConnection, Row
from singulate.runs.run_directory import RunDirectory

METRIC_NAMES = """
WITH RECURSIVE found(name) AS (
    SELECT MIN(name) FROM metrics
    UNION ALL
    SELECT (SELECT MIN(name) FROM metrics WHERE name > found.name)
    FROM found WHERE found.name IS NOT NULL)
SELECT name FROM found WHERE name IS NOT NULL"""


class MetricSeries(NamedTuple):
    """Values of one metric: steps int64 (N,), values float64 (N,), times float64 (N,) [s]."""

    steps: npt.NDArray[np.int64]
    values: npt.NDArray[np.float64]
    times: npt.NDArray[np.float64]


class Starts(NamedTuple):
    """Starts of pushes: ids int64 (N,), steps int64 (N,), positions float32 (N, 2) [m]."""

    ids: npt.NDArray[np.int64]
    steps: npt.NDArray[np.int64]
    positions: npt.NDArray[np.float32]


@dataclass(frozen=True)
class EventRecord:
    """Something that happened in a run: when (seconds since 1970), what, and its details."""

    event_id: int
    time: float
    kind: str
    detail: Mapping[str, Any]


class RunReader:
    """Reads a run's record while a trainer writes it, or after; usable from any thread.

    A record that is not there yet reads as empty. Every question is answered from an index or by
    primary key, so that asking twice a second costs little however long the run is.

    Args:
        run_dir: The run's directory.

    Raises:
        RunError: From every method, if the record is damaged, foreign, or locked for long.
    """

    def __init__(self, run_dir: Path) -> None:
        self._path = RunDirectory(run_dir).record_path
        self._connection = ReadConnection(self._path)

    def close(self) -> None:
        """Let go of the file; the next question opens it again."""
        self._connection.close()

    def revision(self) -> int:
        """A number that changes whenever something was committed."""
        return self._connection.revision()

    def generation(self) -> int:
        """How often the run was rewound to a checkpoint: what was read before may be void."""
        return self._count("SELECT COUNT(*) FROM events WHERE kind = 'rewound'")

    def metric_names(self) -> list[str]:
        """Names of all metrics, sorted."""
        return [name for (name,) in self._connection.rows(METRIC_NAMES)]

    def metrics_since(self, name: str, step: int = -1) -> MetricSeries:
        """Values of a metric after a step, by step.

        Args:
            name: Name of the metric.
            step: Last step that is known already.

        Returns:
            The later values; NaN where a value was not finite.
        """
        rows = self._connection.rows(
            "SELECT step, value, time FROM metrics WHERE name = ? AND step > ? ORDER BY step",
            (name, step),
        )
        return MetricSeries(
            np.array([row[0] for row in rows], dtype=np.int64),
            np.array([math.nan if row[1] is None else row[1] for row in rows], dtype=np.float64),
            np.array([row[2] for row in rows], dtype=np.float64),
        )

    def count_pushes(self) -> int:
        """Number of pushes."""
        return self._count("SELECT COUNT(*) FROM pushes")

    def last_step(self) -> int:
        """Training step of the last push, 0 before the first."""
        return self._count("SELECT COALESCE(MAX(step), 0) FROM pushes")

    def starts(self, step_from: int, step_to: int, limit: int = 10_000) -> npt.NDArray[np.float32]:
        """Where pushes of a window of training started.

        Args:
            step_from: First training step of the window.
            step_to: Last training step of the window.
            limit: How many at most; the newest of the window are given.

        Returns:
            Positions, float32 (N, 2) [m], in the order of training.
        """
        rows = self._connection.rows(
            "SELECT start_x, start_y FROM pushes INDEXED BY pushes_by_step"
            " WHERE step BETWEEN ? AND ? ORDER BY step DESC LIMIT ?",
            (step_from, step_to, limit),
        )
        return np.array(rows[::-1], dtype=np.float32).reshape(-1, 2)

    def starts_since(self, push_id: int = 0) -> Starts:
        """Where pushes started, from the one after `push_id` on.

        Args:
            push_id: Last push that is known already, 0 for none.
        """
        known = self._connection.rows("SELECT step FROM pushes WHERE id = ?", (push_id,))
        rows = self._connection.rows(
            "SELECT id, step, start_x, start_y FROM pushes INDEXED BY pushes_by_step"
            " WHERE step >= ? AND id > ? ORDER BY step",
            (known[0][0] if known else -1, push_id),
        )
        table = np.array(rows, dtype=np.float64).reshape(-1, 4)
        table = table[np.argsort(table[:, 0])]
        return Starts(
            table[:, 0].astype(np.int64), table[:, 1].astype(np.int64), table[:, 2:].astype("f4")
        )

    def push(self, push_id: int) -> PushRecord | None:
        """One push by its number; None where there is none."""
        records = self._pushes("WHERE id = ?", (push_id,))
        return records[0] if records else None

    def pushes_since(self, push_id: int = 0, limit: int = 1000) -> list[PushRecord]:
        """Pushes after one, oldest first, `limit` at most."""
        return self._pushes("WHERE id > ? ORDER BY id LIMIT ?", (push_id, limit))

    def last_pushes(self, num_pushes: int) -> list[PushRecord]:
        """The newest pushes, oldest first."""
        return self._pushes("ORDER BY id DESC LIMIT ?", (num_pushes,))[::-1]

    def events_since(self, event_id: int = 0) -> list[EventRecord]:
        """Events after one, oldest first."""
        rows = self._connection.rows(
            "SELECT id, time, kind, detail FROM events WHERE id > ? ORDER BY id", (event_id,)
        )
        try:
            return [EventRecord(row[0], row[1], row[2], json.loads(row[3])) for row in rows]
        except (ValueError, TypeError) as error:
            raise RunError(f"{self._path}: holds a damaged event ({error})") from error

    def _count(self, query: str) -> int:
        rows = self._connection.rows(query)
        return int(rows[0][0]) if rows else 0

    def _pushes(self, condition: str, values: Row) -> list[PushRecord]:
        names, rows = self._connection.table(f"SELECT * FROM pushes {condition}", values)
        try:
            return [_push_record(dict(zip(names, row, strict=True))) for row in rows]
        except (ValueError, TypeError) as error:
            raise RunError(f"{self._path}: holds a damaged push ({error})") from error


def _push_record(row: Mapping[str, Any]) -> PushRecord:
    terms = {name[2:]: row[name] for name in row if name.startswith("r_")}
    return PushRecord(
        step=row["step"],
        episode=row["episode"],
        push=Push((row["start_x"], row["start_y"]), (row["dir_x"], row["dir_y"]), row["length"]),
        reward=row["reward"],
        terms={name: value for name, value in terms.items() if value is not None},
        is_success=bool(row["is_success"]),
        outcome=row["outcome"],
        poses=poses_from_json(row["poses"]),
        predicted=row["predicted"],
        push_id=row["id"],
    )
