"""The laboratory's end of training: a thread that reads run directories and sends control."""

import queue
import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from app.commands import (
    PauseTraining,
    ResumeTraining,
    SaveCheckpoint,
    StartTraining,
    StopTraining,
    WatchRun,
)
from app.notices import NoticeBoard
from app.snapshot import RunSnapshot
from app.training.desk import TrainingDesk
from singulate.exceptions import InvalidValueError, SingulateError

_READ_INTERVAL_S = 0.4

TrainingCommand = (
    StartTraining | PauseTraining | ResumeTraining | StopTraining | SaveCheckpoint | WatchRun
)


@dataclass(frozen=True)
class TrainingView:
    """What the thread last read."""

    run: RunSnapshot | None = None
    policies: tuple[tuple[str, str], ...] = ()
    runs: tuple[str, ...] = ()


class TrainingLink:
    """Watches a run and passes commands on; disks and databases never hold the page up.

    Args:
        runs_dir: Where runs are made and found.
        checkpoints_dir: Where policies that can be loaded are found.
        run_dir: Run to watch from the start; otherwise the newest one that is alive, if any.
        notices: Where problems are told.

    Raises:
        RunError: If `run_dir` is given and holds no run.
    """

    def __init__(
        self, runs_dir: Path, checkpoints_dir: Path, run_dir: Path | None, notices: NoticeBoard
    ) -> None:
        self._notices = notices
        self._desk = TrainingDesk(runs_dir, checkpoints_dir, run_dir)
        self._commands: queue.Queue[TrainingCommand | None] = queue.Queue()
        self._problems: queue.Queue[str] = queue.Queue()
        self._view = TrainingView()
        self._thread = threading.Thread(target=self._work, name="training", daemon=True)
        self._thread.start()

    @property
    def snapshot(self) -> RunSnapshot | None:
        """The watched run."""
        return self._view.run

    @property
    def policies(self) -> tuple[tuple[str, str], ...]:
        """Policies that can be loaded: (label, source)."""
        return self._view.policies

    @property
    def runs(self) -> tuple[str, ...]:
        """Run directories, newest first."""
        return self._view.runs

    @property
    def started_run(self) -> str:
        """Directory of the run that was started here last; empty where none was."""
        return self._desk.started_run

    @property
    def pid(self) -> int | None:
        """Process id of the trainer that was started here and is alive."""
        return self._desk.trainer_pid

    def obey(self, command: object) -> None:
        """Carry a command out soon, on the thread.

        Raises:
            InvalidValueError: If it is no command of training.
        """
        if not isinstance(command, TrainingCommand):
            raise InvalidValueError("command", command, "one of app.commands")
        self._commands.put(command)

    def update(self) -> None:
        """Tell what went wrong on the thread."""
        while not self._problems.empty():
            self._notices.add(self._problems.get())

    def ask_to_stop(self) -> None:
        """Have a trainer that was started here save a checkpoint and stop; returns at once."""
        self._commands.put(None)

    def close(self, timeout_s: float = 5.0) -> Path | None:
        """Wait for the trainer that was asked to stop; a slow one goes on and ends by itself.

        Returns:
            Its run directory, if there was a trainer that had begun its run.
        """
        self.ask_to_stop()
        self._thread.join(timeout_s)
        self._desk.wait_for_trainer(timeout_s)
        return self._desk.stopped_run

    def _work(self) -> None:
        while True:
            self._try(self._look)
            try:
                command = self._commands.get(timeout=_READ_INTERVAL_S)
            except queue.Empty:
                continue
            if command is None:
                break
            self._try(lambda: self._desk.obey(command))  # noqa: B023
        self._try(self._desk.stop_trainer)
        self._desk.close()

    def _look(self) -> None:
        run = self._desk.read()
        self._view = TrainingView(run, self._desk.policies, self._desk.runs)

    def _try(self, act: Callable[[], None]) -> None:
        try:
            act()
        except SingulateError as error:
            self._problems.put(str(error))
        except Exception as error:
            self._problems.put(f"Watching the training failed ({type(error).__name__}: {error}).")
