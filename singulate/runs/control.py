"""Messages to a trainer: small files that appear at once and are removed when read."""

import itertools
import json
import os
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from singulate.checkpoints.durable import replace_file
from singulate.exceptions import InvalidValueError, RunError
from singulate.runs.json_text import parse_json_object
from singulate.runs.run_directory import RunDirectory

CONTROL_COMMANDS = ("pause", "resume", "stop", "checkpoint")
MAX_MESSAGE_BYTES = 1 << 16
MIN_INTERVAL_S = 0.05

_counter = itertools.count()


@dataclass(frozen=True)
class ControlMessage:
    """One message.

    Attributes:
        command: One of `CONTROL_COMMANDS`.
        values: What came with it.
    """

    command: str
    values: Mapping[str, Any]


def send_control(run_dir: Path, command: str, **values: Any) -> None:
    """Ask a run's trainer for something; it acts at its next safe point.

    Args:
        run_dir: The run's directory.
        command: One of `CONTROL_COMMANDS`.
        **values: Plain JSON values.

    Raises:
        InvalidValueError: If the command is unknown or a value cannot be sent.
        RunError: If there is no run or it is not writable.
    """
    if command not in CONTROL_COMMANDS:
        raise InvalidValueError("command", command, ", ".join(CONTROL_COMMANDS))
    try:
        text = json.dumps({"command": command, "values": values}, allow_nan=False)
    except (TypeError, ValueError):
        raise InvalidValueError("values", values, "plain JSON values") from None
    run = RunDirectory(run_dir).open()
    name = f"{time.time_ns():020d}-{os.getpid()}-{next(_counter):06d}.json"
    try:
        run.control_path.mkdir(exist_ok=True)
        replace_file(run.control_path / name, text.encode(), is_durable=False)
    except OSError as error:
        raise RunError(f"{run_dir}: cannot be written ({error.strerror or error})") from error


class ControlInbox:
    """The trainer's end; asking is cheap enough for every push.

    Args:
        run_dir: The run's directory.
    """

    def __init__(self, run_dir: Path) -> None:
        self._directory = RunDirectory(run_dir).control_path
        self._last_look = -MIN_INTERVAL_S

    def drain(self) -> list[ControlMessage]:
        """Take the messages that have come, in the order of sending.

        The disk is looked at 20 times a second at most. What is no valid message is removed.
        """
        now = time.monotonic()
        if now - self._last_look < MIN_INTERVAL_S:
            return []
        self._last_look = now
        return self._take()

    def clear(self) -> None:
        """Drop messages that were meant for an earlier trainer of this run."""
        self._take()

    def _take(self) -> list[ControlMessage]:
        try:
            names = sorted(n for n in os.listdir(self._directory) if not n.startswith("."))
        except FileNotFoundError:
            return []
        messages = [_consume(self._directory / name) for name in names]
        return [message for message in messages if message is not None]


def _consume(path: Path) -> ControlMessage | None:
    try:
        with path.open("rb") as file:
            data = file.read(MAX_MESSAGE_BYTES + 1)
        path.unlink()
        content = parse_json_object(data)
    except (OSError, ValueError):
        return None
    command, values = content.get("command"), content.get("values")
    if command not in CONTROL_COMMANDS or not isinstance(values, dict):
        return None
    return ControlMessage(command, values)
