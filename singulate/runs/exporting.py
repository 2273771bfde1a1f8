"""A run's record as CSV files."""

import csv
from collections.abc import Iterator
from pathlib import Path

from singulate.exceptions import RunError
from singulate.runs.read_connection import ReadConnection, Row
from singulate.runs.reader import METRIC_NAMES
from singulate.runs.run_directory import RunDirectory
from singulate.runs.schema import PUSH_COLUMNS

METRIC_HEADER = ("name", "step", "value", "time")
PUSH_HEADER = ("id", *PUSH_COLUMNS)
NUM_ROWS_AT_ONCE = 5000
"""So few that the trainer is not kept from writing."""


def export_run(run_dir: Path, directory: Path) -> list[Path]:
    """Write ``metrics.csv`` and ``pushes.csv``; a living run is not disturbed.

    Args:
        run_dir: The run's directory.
        directory: Where the files go; it is made, files of these names are replaced.

    Returns:
        The files.

    Raises:
        RunError: If there is no run, or the directory is not writable.
    """
    record = ReadConnection(RunDirectory(run_dir).open().record_path)
    names = [name for (name,) in record.rows(METRIC_NAMES)]
    tables = {
        "metrics.csv": (METRIC_HEADER, _metric_rows(record, names)),
        "pushes.csv": (PUSH_HEADER, _push_rows(record)),
    }
    try:
        directory.mkdir(parents=True, exist_ok=True)
        for name, (header, rows) in tables.items():
            _write_csv(directory / name, header, rows)
    except OSError as error:
        raise RunError(f"{directory}: cannot be written ({error.strerror or error})") from error
    finally:
        record.close()
    return [directory / name for name in tables]


def _write_csv(path: Path, header: tuple[str, ...], rows: Iterator[Row]) -> None:
    partial = path.with_name(f".{path.name}.partial")
    try:
        with partial.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(header)
            writer.writerows(rows)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)


def _metric_rows(record: ReadConnection, names: list[str]) -> Iterator[Row]:
    query = "SELECT name, step, value, time FROM metrics WHERE name = ? ORDER BY step"
    for name in names:
        yield from record.rows(query, (name,))


def _push_rows(record: ReadConnection) -> Iterator[Row]:
    columns = ", ".join(PUSH_HEADER)
    query = f"SELECT {columns} FROM pushes WHERE id > ? ORDER BY id LIMIT {NUM_ROWS_AT_ONCE}"
    last = 0
    while rows := record.rows(query, (last,)):
        yield from rows
        last = rows[-1][0]
