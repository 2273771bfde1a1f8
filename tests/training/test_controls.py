import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from singulate.runs import Heartbeat, RunDirectory, RunStatus, send_control
from singulate.training.controls import Controls


@pytest.fixture
def controls(tmp_path: Path) -> Iterator[Controls]:
    RunDirectory(tmp_path / "run").create({})
    status = RunStatus(state="running")
    with (
        Heartbeat(tmp_path / "run", status) as heartbeat,
        Controls(tmp_path / "run", heartbeat) as listening,
    ):
        yield listening


def test_the_status_says_pausing_before_the_trainer_is_asked(
    controls: Controls, tmp_path: Path
) -> None:
    send_control(tmp_path / "run", "pause")
    _wait(lambda: controls.is_pausing)
    assert _written_state(tmp_path) == "pausing"


def test_a_paused_trainer_waits_until_it_is_resumed(controls: Controls, tmp_path: Path) -> None:
    controls.request("pause")
    waiting = threading.Thread(target=controls.wait_while_paused, daemon=True)
    waiting.start()
    _wait(lambda: _written_state(tmp_path) == "paused")
    assert waiting.is_alive()
    send_control(tmp_path / "run", "resume")
    waiting.join(timeout=5)
    assert not waiting.is_alive()
    assert _written_state(tmp_path) == "running"


def test_a_checkpoint_can_be_asked_for_once_while_paused(controls: Controls) -> None:
    controls.request("pause")
    controls.request("checkpoint")
    controls.wait_while_paused()
    assert controls.take_checkpoint_request()
    assert not controls.take_checkpoint_request()


def test_stopping_ends_a_pause_and_cannot_be_taken_back(controls: Controls, tmp_path: Path) -> None:
    controls.request("pause")
    controls.request("stop")
    controls.wait_for_resume()
    controls.request("resume")
    assert controls.is_stopping
    assert _written_state(tmp_path) == "stopping"


def _written_state(tmp_path: Path) -> str:
    """The state in the file; nobody holds the run's lock here, so it reads as dead."""
    import json

    return str(json.loads((tmp_path / "run" / "status.json").read_text())["state"])


def _wait(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 10.0
    while not condition():
        assert time.monotonic() < deadline, "timed out"
        time.sleep(0.01)
