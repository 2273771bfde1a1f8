import time
from pathlib import Path

import pytest

from singulate.exceptions import InvalidValueError, RunError
from singulate.runs import ControlInbox, ControlMessage, send_control
from singulate.runs.control import MIN_INTERVAL_S


def test_messages_arrive_once_and_in_order(run_dir: Path) -> None:
    inbox = ControlInbox(run_dir)
    for command in ("pause", "checkpoint", "resume"):
        send_control(run_dir, command)
    send_control(run_dir, "stop", reason="tea")
    assert inbox.drain() == [
        ControlMessage("pause", {}),
        ControlMessage("checkpoint", {}),
        ControlMessage("resume", {}),
        ControlMessage("stop", {"reason": "tea"}),
    ]
    assert list((run_dir / "control").iterdir()) == []


def test_the_disk_is_looked_at_only_now_and_then(run_dir: Path) -> None:
    inbox = ControlInbox(run_dir)
    begin = time.monotonic()
    assert inbox.drain() == []
    send_control(run_dir, "pause")
    while not (messages := inbox.drain()):
        assert time.monotonic() - begin < 10.0
    assert messages == [ControlMessage("pause", {})]
    assert time.monotonic() - begin >= MIN_INTERVAL_S


def test_old_messages_can_be_dropped(run_dir: Path) -> None:
    send_control(run_dir, "stop")
    inbox = ControlInbox(run_dir)
    inbox.clear()
    assert inbox.drain() == []


@pytest.mark.parametrize(
    "data",
    [b"", b"\xff", b"[]", b'{"command": "explode", "values": {}}', b'{"command": "stop"}',
     b'{"command": "stop", "values": 3}', b'{"command": ["stop"], "values": {}}',
     b"[" * 60_000, b" " * 100_000 + b'{"command": "stop", "values": {}}'],
)  # fmt: skip
def test_what_is_no_message_is_removed(run_dir: Path, data: bytes) -> None:
    (run_dir / "control" / "1.json").write_bytes(data)
    assert ControlInbox(run_dir).drain() == []
    assert list((run_dir / "control").iterdir()) == []


def test_bad_commands(run_dir: Path, tmp_path: Path) -> None:
    with pytest.raises(InvalidValueError, match="pause, resume, stop, checkpoint"):
        send_control(run_dir, "explode")
    with pytest.raises(InvalidValueError, match="plain JSON"):
        send_control(run_dir, "stop", when=object())
    with pytest.raises(RunError, match="no such run directory"):
        send_control(tmp_path / "nowhere", "stop")
