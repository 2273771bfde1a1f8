"""Where runs are started, steered and read; used by the training thread alone."""

import time
from dataclasses import replace
from pathlib import Path

from app.commands import (
    PauseTraining,
    ResumeTraining,
    SaveCheckpoint,
    StartTraining,
    StopTraining,
    WatchRun,
)
from app.snapshot import RunSnapshot
from app.training.catalogue import find_policies, find_runs
from app.training.launched import Launched
from app.training.run_watch import RunWatch
from app.training.starting import training_config
from singulate.exceptions import RunError
from singulate.runs.control import send_control
from singulate.runs.naming import new_run_directory
from singulate.runs.run_directory import RunDirectory

_LIST_INTERVAL_S = 2.0
_ENDED = {"stopped", "died", "failed"}


class TrainingDesk:
    """One watched run, and at most one trainer that was started here.

    Args:
        runs_dir: Where runs are made and found.
        checkpoints_dir: Where policies that can be loaded are found.
        run_dir: Run to watch; otherwise the newest one that is alive, if any.

    Attributes:
        runs: Run directories, newest first.
        policies: Policies that can be loaded: (label, source).
        started_run: Directory of the run that was started here last; empty where none was.
        stopped_run: The run that `stop_trainer` has stopped, if any; it can be continued.

    Raises:
        RunError: If `run_dir` is given and holds no run.
    """

    def __init__(self, runs_dir: Path, checkpoints_dir: Path, run_dir: Path | None) -> None:
        self._runs_dir = runs_dir
        self._checkpoints_dir = checkpoints_dir
        self._launched: Launched | None = None
        self._watch: RunWatch | None = None
        self._snapshot: RunSnapshot | None = None
        self._listed_at = 0.0
        self._has_looked = False
        self._awaits_run = False
        self.runs: tuple[str, ...] = ()
        self.policies: tuple[tuple[str, str], ...] = ()
        self.started_run = ""
        self.stopped_run: Path | None = None
        if run_dir is not None:
            self._watch_run(run_dir)

    @property
    def trainer_pid(self) -> int | None:
        """The trainer that was started here, while it lives."""
        launched = self._launched
        return launched.pid if launched is not None and launched.is_alive else None

    def read(self) -> RunSnapshot | None:
        """The watched run as it is now.

        Raises:
            RunError: If its directory is gone or damaged; it is no longer watched then.
        """
        if time.monotonic() - self._listed_at > _LIST_INTERVAL_S:
            self._list()
        if self._launched is not None and self._awaits_run:
            self._snapshot = self._launched.snapshot()
            if RunDirectory(self._launched.run_dir).is_run:
                self._watch_run(self._launched.run_dir)
        if self._watch is not None:
            self._read_watch(self._watch)
        return self._snapshot

    def obey(self, command: object) -> None:
        """Carry out a command of training.

        Raises:
            SingulateError: If it cannot be carried out.
        """
        match command:
            case StartTraining():
                self._start(command)
            case WatchRun(run_dir):
                self._watch_run(Path(run_dir))
            case ResumeTraining():
                self._resume()
            case PauseTraining():
                self._send("pause", "pausing")
            case StopTraining():
                self._send("stop", "stopping")
            case SaveCheckpoint():
                self._send("checkpoint")

    def stop_trainer(self) -> None:
        """Ask the trainer that was started here to save a checkpoint and stop."""
        launched = self._launched
        if launched is not None and launched.is_alive:
            launched.stop()
            self.stopped_run = launched.run_dir if RunDirectory(launched.run_dir).is_run else None

    def wait_for_trainer(self, timeout_s: float) -> None:
        """Wait for the end of the trainer that was started here."""
        if self._launched is not None:
            self._launched.wait(timeout_s)

    def close(self) -> None:
        """Let go of the watched run."""
        if self._watch is not None:
            self._watch.close()

    def _read_watch(self, watch: RunWatch) -> None:
        try:
            self._snapshot = self._explained(watch.read())
        except (RunError, OSError) as error:
            self._forget_watch()
            self._snapshot = None
            self._listed_at = 0.0
            raise RunError(f"{error}; this run is no longer watched") from error

    def _explained(self, run: RunSnapshot) -> RunSnapshot:
        """Say what the operating system knows about the end of a trainer that is our child."""
        launched = self._launched
        if launched is None or str(launched.run_dir) != run.run_dir or launched.is_alive:
            return run
        if run.state == "starting" and self._watch is not None:
            self._watch.note_request("")
        return replace(run, reason=launched.death or run.reason) if run.state == "died" else run

    def _start(self, command: StartTraining) -> None:
        self._check_free()
        config = training_config(command)
        run_dir = new_run_directory(self._runs_dir, config.agent, config.env.scenario)
        self._launched = Launched.start(config, run_dir)
        self.started_run = str(run_dir)
        self._forget_watch()
        self._awaits_run = True
        self._listed_at = 0.0

    def _resume(self) -> None:
        run = self._watched()
        state = self._snapshot.state if self._snapshot else ""
        if state in _ENDED:
            self._check_free()
            self._launched = Launched.resume(run.path)
            if self._watch is not None:
                self._watch.note_request("starting")
        elif state == "finished":
            raise RunError(f"{run.path.name} has finished all its steps; start a new run")
        else:
            send_control(run.path, "resume")

    def _send(self, command: str, state: str = "") -> None:
        run = self._watched()
        current = self._snapshot.state if self._snapshot else ""
        if current in _ENDED or current == "finished":
            raise RunError(f"{run.path.name} is not running ({current}); resume it first")
        send_control(run.path, command)
        if self._watch is not None and state:
            self._watch.note_request(state)

    def _watched(self) -> RunDirectory:
        if self._watch is None:
            raise RunError("no run is being watched yet; start training first")
        return self._watch.run

    def _check_free(self) -> None:
        if self._launched is not None and self._launched.is_alive:
            raise RunError(
                f"{self._launched.run_dir.name} is still training; stop it before you start another"
            )

    def _watch_run(self, run_dir: Path) -> None:
        RunDirectory(run_dir).open()
        self._forget_watch()
        self._watch = RunWatch(run_dir)

    def _forget_watch(self) -> None:
        if self._watch is not None:
            self._watch.close()
        self._watch = None
        self._awaits_run = False

    def _list(self) -> None:
        found = find_runs(self._runs_dir)
        if not self._has_looked:
            self._has_looked = True
            alive = [run.path for run in found if run.status is not None and run.status.is_alive]
            if alive and self._watch is None and self._launched is None:
                self._watch_run(alive[0])
        self.runs = tuple(str(run.path) for run in found)
        self.policies = find_policies(self._checkpoints_dir, is_watching=self._watch is not None)
        self._listed_at = time.monotonic()
