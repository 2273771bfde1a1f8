"""Starts a trainer as a process of its own; imports no torch."""

import json
import os
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from singulate.engine.standing_back import set_back
from singulate.exceptions import RunError
from singulate.runs import log_tail
from singulate.runs.run_directory import RunDirectory
from singulate.training.config import TrainingConfig

LAUNCH_NAME = "launch.json"
_NICENESS = 5
"""How far a trainer stands back: the page and the pushes that people make come first."""


@dataclass(frozen=True)
class TrainerProcess:
    """A trainer that was started from here; it goes on if whoever started it is killed.

    The dashboard, when it ends in order, asks its trainer to save a checkpoint and stop.

    Attributes:
        run_dir: Its run directory.
        process: The operating system's process.
    """

    run_dir: Path
    process: "subprocess.Popen[bytes]"

    def death(self) -> str | None:
        """Why it ended, one line; None while it lives or if it ended well.

        Asking also lets the operating system forget an ended process.
        """
        code = self.process.poll()
        if code is None or code == 0:
            return None
        what = f"was killed by signal {-code}" if code < 0 else f"ended with exit status {code}"
        last = log_tail(self.run_dir)
        said = f": {last[0]}" if last else ""
        return f"trainer process {self.process.pid} {what}{said}"


def start_trainer(
    config: TrainingConfig | None, run_dir: Path, total_timesteps: int | None = None
) -> TrainerProcess:
    """Start ``singulate train`` in the background.

    Args:
        config: Settings of a new run; None to continue the run in `run_dir`.
        run_dir: The run's directory.
        total_timesteps: New total when continuing.

    Raises:
        RunError: If the directory cannot be written, or there is no run to continue.
    """
    command = [sys.executable, "-m", "singulate", "train"]
    try:
        if config is None:
            RunDirectory(run_dir).open()
            command += ["--resume", str(run_dir)]
            if total_timesteps is not None:
                command += ["--steps", str(total_timesteps)]
        else:
            run_dir.mkdir(parents=True, exist_ok=True)
            launch_path = run_dir / LAUNCH_NAME
            launch_path.write_text(json.dumps(config.to_dict(), indent=2) + "\n")
            command += ["--config", str(launch_path), "--run-dir", str(run_dir)]
        with (run_dir / "trainer.log").open("ab") as log:
            process = subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=log,
                start_new_session=True,
                env=os.environ | {"PYTHONPATH": _python_path()},
            )
    except OSError as error:
        raise RunError(f"{run_dir}: cannot be written ({error.strerror or error})") from error
    with suppress(OSError):
        set_back(process.pid, os.nice(0) + _NICENESS)
    return TrainerProcess(run_dir, process)


def _python_path() -> str:
    package_parent = str(Path(__file__).resolve().parents[2])
    known = os.environ.get("PYTHONPATH")
    return package_parent if not known else package_parent + os.pathsep + known
