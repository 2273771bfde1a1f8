"""Tables of a run's record."""

import sqlite3

from singulate.rewards.terms import TERMS

SCHEMA_VERSION = 1
APPLICATION_ID = 0x53474C54
"""``SGLT``: marks the file as a record of this project."""

TERM_COLUMNS = tuple(f"r_{term}" for term in TERMS)
PUSH_COLUMNS = (
    "step",
    "episode",
    "start_x",
    "start_y",
    "dir_x",
    "dir_y",
    "length",
    "predicted",
    "reward",
    *TERM_COLUMNS,
    "is_success",
    "outcome",
    "poses",
)

STATEMENTS = (
    """CREATE TABLE metrics (
        name TEXT NOT NULL, step INTEGER NOT NULL, value REAL, time REAL NOT NULL,
        PRIMARY KEY (name, step)) WITHOUT ROWID""",
    f"""CREATE TABLE pushes (
        id INTEGER PRIMARY KEY, step INTEGER NOT NULL, episode INTEGER NOT NULL,
        start_x REAL NOT NULL, start_y REAL NOT NULL, dir_x REAL NOT NULL, dir_y REAL NOT NULL,
        length REAL NOT NULL, predicted REAL, reward REAL NOT NULL,
        {"".join(f"{column} REAL, " for column in TERM_COLUMNS)}
        is_success INTEGER NOT NULL, outcome TEXT NOT NULL, poses TEXT NOT NULL)""",
    # Start positions and counts are read from this index alone, without the wide rows.
    "CREATE INDEX pushes_by_step ON pushes (step, start_x, start_y)",
    """CREATE TABLE events (
        id INTEGER PRIMARY KEY, time REAL NOT NULL, kind TEXT NOT NULL, detail TEXT NOT NULL)""",
    f"PRAGMA application_id = {APPLICATION_ID}",
    f"PRAGMA user_version = {SCHEMA_VERSION}",
)


def journal_mode(version: tuple[int, int, int] = sqlite3.sqlite_version_info) -> str:
    """How a record is kept whole with this version of SQLite.

    Write-ahead logging lets readers and the writer pass each other, but versions before 3.44.6,
    3.50.7 and 3.51.3 can corrupt the file (https://sqlite.org/wal.html, "the WAL-reset bug").

    >>> journal_mode((3, 40, 1)), journal_mode((3, 50, 7)), journal_mode((3, 51, 2))
    ('DELETE', 'WAL', 'DELETE')
    """
    is_fixed = (
        version >= (3, 51, 3) or (3, 50, 7) <= version < (3, 51) or (3, 44, 6) <= version < (3, 45)
    )
    return "WAL" if is_fixed else "DELETE"


def create_tables(connection: sqlite3.Connection) -> None:
    """Make the tables of a new record; the caller has begun a transaction."""
    for statement in STATEMENTS:
        connection.execute(statement)


def add_missing_terms(connection: sqlite3.Connection) -> None:
    """Add columns for reward terms that are newer than the record."""
    known = {row[1] for row in connection.execute("PRAGMA table_info(pushes)")}
    for column in TERM_COLUMNS:
        if column not in known:
            connection.execute(f"ALTER TABLE pushes ADD COLUMN {column} REAL")


def version_problem(connection: sqlite3.Connection) -> str | None:
    """Why this file is not a record that this code can use; None where it is."""
    application = connection.execute("PRAGMA application_id").fetchone()[0]
    version = connection.execute("PRAGMA user_version").fetchone()[0]
    if application != APPLICATION_ID:
        return "not a record of a run"
    if version != SCHEMA_VERSION:
        return f"record version {version} is unknown; known: {SCHEMA_VERSION}"
    return None
