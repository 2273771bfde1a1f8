"""A read-only connection to an SQLite file that another process writes, replaces or abandons."""

import contextlib
import sqlite3
import threading
from pathlib import Path
from typing import Any
from urllib.parse import quote

from singulate.exceptions import RunError
from singulate.runs.schema import version_problem

LOCK_TIMEOUT_S = 5.0
"""On a slow disk a commit holds the file for more than a second."""

Row = tuple[Any, ...]


class ReadConnection:
    """Opens on demand, follows a file that was replaced, and mends one whose writer was killed.

    Args:
        path: The file; it need not exist.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._guard = threading.Lock()
        self._connection: sqlite3.Connection | None = None
        self._identity: tuple[int, int] | None = None
        self._num_opened = 0

    def rows(self, query: str, values: Row = ()) -> list[Row]:
        """Answer a query; empty where there is no file yet.

        Raises:
            RunError: If the file is damaged, foreign, or locked for long.
        """
        return self.table(query, values)[1]

    def table(self, query: str, values: Row = ()) -> tuple[list[str], list[Row]]:
        """Names of the columns, and the rows.

        Raises:
            RunError: If the file is damaged, foreign, or locked for long.
        """
        with self._guard:
            try:
                return self._answer(query, values)
            except sqlite3.Error as error:
                if not self._is_mendable(error):
                    raise self._failure(error) from error
            self._disconnect()
            try:
                return self._answer(query, values)
            except sqlite3.Error as error:
                raise self._failure(error) from error

    def revision(self) -> int:
        """A number that changes whenever the file was committed to or replaced."""
        rows = self.rows("PRAGMA data_version")
        return (self._num_opened << 32) + int(rows[0][0]) if rows else 0

    def close(self) -> None:
        """Close the file; harmless when it is not open."""
        with self._guard:
            self._disconnect()

    def _disconnect(self) -> None:
        if self._connection is not None:
            self._connection.close()
            self._connection = None

    def _current(self) -> sqlite3.Connection | None:
        """The open connection; None where there is no file, or one that is still being made."""
        try:
            found = self._path.stat()
        except FileNotFoundError:
            self._disconnect()
            return None
        except OSError as error:
            raise RunError(f"{self._path}: cannot be read ({error.strerror or error})") from error
        identity = (found.st_dev, found.st_ino)
        if identity != self._identity:
            self._disconnect()
        if self._connection is None:
            if found.st_size == 0:
                return None
            self._connection = self._open()
            self._identity = identity
            self._num_opened += 1
        return self._connection

    def _answer(self, query: str, values: Row) -> tuple[list[str], list[Row]]:
        connection = self._current()
        if connection is None:
            return [], []
        cursor = connection.execute(query, values)
        return [column[0] for column in cursor.description], cursor.fetchall()

    def _failure(self, error: sqlite3.Error) -> RunError:
        self._disconnect()
        return RunError(f"{self._path}: cannot be read ({error})")

    def _is_mendable(self, error: sqlite3.Error) -> bool:
        is_busy = getattr(error, "sqlite_errorcode", 0) & 0xFF == sqlite3.SQLITE_BUSY
        return isinstance(error, sqlite3.OperationalError) and not is_busy

    def _open(self) -> sqlite3.Connection:
        connection = self._connect("ro")
        try:
            _touch(connection)
            problem = version_problem(connection)
        except sqlite3.Error as error:
            connection.close()
            if not self._is_mendable(error):
                raise
            # A writer that was killed inside a commit leaves a journal that has to be rolled back,
            # which a read-only connection may not do. A living writer's journal is left alone.
            with contextlib.closing(self._connect("rw")) as mending:
                _touch(mending)
            connection = self._connect("ro")
            problem = version_problem(connection)
        if problem is not None:
            connection.close()
            raise RunError(f"{self._path}: {problem}")
        return connection

    def _connect(self, mode: str) -> sqlite3.Connection:
        return sqlite3.connect(
            f"file:{quote(str(self._path.absolute()))}?mode={mode}",
            uri=True,
            timeout=LOCK_TIMEOUT_S,
            isolation_level=None,
            check_same_thread=False,
        )


def _touch(connection: sqlite3.Connection) -> None:
    connection.execute("SELECT COUNT(*) FROM sqlite_master").fetchone()
