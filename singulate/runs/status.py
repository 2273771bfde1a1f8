"""How a run is doing, and whether its trainer is still there to say so."""

import json
import socket
import time
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any, Literal, get_args

from singulate.checkpoints.durable import replace_file
from singulate.exceptions import RunError
from singulate.finite import is_finite_number
from singulate.runs.json_text import parse_json_object
from singulate.runs.lock import lock_holder
from singulate.runs.run_directory import RunDirectory

RunState = Literal[
    "starting",
    "running",
    "pausing",
    "paused",
    "stopping",
    "stopped",
    "finished",
    "failed",
    "died",
]
"""``died`` is never written: a reader finds it out."""

FINAL_STATES: frozenset[RunState] = frozenset({"stopped", "finished", "failed"})
STARTUP_GRACE_S = 60.0
"""A new run may take this long until its trainer says something."""
HEARTBEAT_TIMEOUT_S = 30.0
"""A trainer on another machine is given up after this silence."""
LOG_TAIL_BYTES = 8192


@dataclass(frozen=True)
class RunStatus:
    """State of a run.

    Attributes:
        state: What it is doing.
        pid: Process of the trainer, 0 where none is known.
        host: Machine of the trainer.
        num_steps: Training steps done.
        total_steps: Training steps asked for.
        pushes_per_second: Current speed.
        eta_s: Time left [s], None while it cannot be told.
        updated_at: Last sign of life, seconds since 1970.
        error: Why it failed or died, one line; empty otherwise.
        notice: What went wrong last without stopping it, one line; empty otherwise.
        is_alive: Whether the trainer is there; found out by the reader, never written.
    """

    state: RunState = "starting"
    pid: int = 0
    host: str = ""
    num_steps: int = 0
    total_steps: int = 0
    pushes_per_second: float = 0.0
    eta_s: float | None = None
    updated_at: float = 0.0
    error: str = ""
    notice: str = ""
    is_alive: bool = False

    def age_s(self, now: float | None = None) -> float:
        """Time since the last sign of life [s]."""
        return max(0.0, (time.time() if now is None else now) - self.updated_at)


def write_status(run_dir: Path, status: RunStatus) -> None:
    """Replace a run's status at once.

    Raises:
        OSError: If it cannot be written.
    """
    content = asdict(status)
    del content["is_alive"]
    replace_file(RunDirectory(run_dir).status_path, json.dumps(content).encode(), is_durable=False)


def read_status(run_dir: Path, now: float | None = None) -> RunStatus:
    """State of a run as seen from outside: a trainer that was killed shows as ``died``.

    Args:
        run_dir: The run's directory.
        now: Seconds since 1970; the clock's where omitted.

    Raises:
        RunError: If there is no run or its status is damaged.
    """
    run = RunDirectory(run_dir).open()
    now = time.time() if now is None else now
    holder = lock_holder(run_dir)
    if not run.status_path.exists():
        created = _created(run)
        status = RunStatus(pid=holder or 0, host=socket.gethostname(), updated_at=created)
        is_alive = holder is not None or now - created < STARTUP_GRACE_S
    else:
        status = _load(run.status_path)
        if status.state in FINAL_STATES:
            return status
        if status.host == socket.gethostname():
            # A trainer that resumes may have taken the lock and spoken since the first look.
            is_alive = holder is not None or lock_holder(run_dir) is not None
        else:
            is_alive = now - status.updated_at < HEARTBEAT_TIMEOUT_S
    if is_alive:
        return replace(status, is_alive=True)
    return replace(status, state="died", error=_reason(run, status, now))


def _created(run: RunDirectory) -> float:
    try:
        return run.config_path.stat().st_mtime
    except OSError as error:
        raise RunError(f"{run.path}: cannot be read ({error.strerror or error})") from error


def log_tail(run_dir: Path, num_lines: int = 1) -> list[str]:
    """Last lines of a trainer's standard error that are not empty."""
    path = RunDirectory(run_dir).log_path
    try:
        with path.open("rb") as file:
            file.seek(max(0, path.stat().st_size - LOG_TAIL_BYTES))
            text = file.read().decode(errors="replace")
    except OSError:
        return []
    lines = [line.strip() for line in text.splitlines()]
    return [line for line in lines if line][-num_lines:]


def _reason(run: RunDirectory, status: RunStatus, now: float) -> str:
    who = f"process {status.pid}" if status.pid else "the trainer"
    age = status.age_s(now)
    reason = f"{who} ended without a word (killed?), last sign of life {age:.0f} s ago"
    last = log_tail(run.path)
    return f"{reason}; its last output: {last[0]}" if last else reason


def _load(path: Path) -> RunStatus:
    try:
        status = RunStatus(**parse_json_object(path.read_bytes()))
    except (OSError, ValueError, TypeError) as error:
        raise RunError(f"{path}: cannot be read ({error})") from error
    for field in fields(RunStatus):
        if not _is_valid(field.name, getattr(status, field.name)):
            raise RunError(f"{path}: {field.name} is not valid")
    return status


def _is_valid(name: str, value: Any) -> bool:
    if name == "state":
        return value in get_args(RunState) and value != "died"
    if name in ("host", "error", "notice"):
        return isinstance(value, str)
    if name == "is_alive":
        return value is False
    if name == "eta_s" and value is None:
        return True
    is_whole = isinstance(value, int) or name not in ("pid", "num_steps", "total_steps")
    return is_whole and is_finite_number(value)
