"""One watched run: what its directory says, read piece by piece."""

import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from app.snapshot import Curve, RunSnapshot
from app.training.growing import GrowingArray
from singulate.exceptions import RunError
from singulate.runs.reader import RunReader
from singulate.runs.run_directory import RunDirectory
from singulate.runs.status import RunStatus, read_status

_UNANSWERED = {
    "starting": {"stopped", "failed", "died"},
    "pausing": {"running"},
    "stopping": {"running", "pausing", "paused"},
}
"""What was asked for, and the states in which the trainer has not taken notice of it yet."""
_ANSWER_TIMEOUT_S = 60.0


class RunWatch:
    """Reads a run's status and the new part of its record; used by one thread.

    Args:
        run_dir: The run's directory, which exists.
    """

    def __init__(self, run_dir: Path) -> None:
        self.run = RunDirectory(run_dir)
        self._reader = RunReader(run_dir)
        self._config: Mapping[str, Any] = {}
        self._asked = ""
        self._asked_at = 0.0
        self._record_revision = -1
        self._revision = 0
        self._known = _ReadSoFar()

    def read(self) -> RunSnapshot:
        """The run as it is now.

        Raises:
            RunError: If the directory is damaged.
        """
        status = read_status(self.run.path)
        self._config = self._config or self.run.read_config()
        self._read_record()
        checkpoint = self.run.latest_checkpoint()
        env = self._config.get("env")
        state = self._state(status)
        return RunSnapshot(
            run_dir=str(self.run.path),
            name=self.run.path.name,
            agent=str(self._config.get("agent", "")),
            scenario=str(env.get("scenario", "")) if isinstance(env, Mapping) else "",
            state=state,
            reason=(status.error or status.notice) if state == status.state else "",
            num_steps=status.num_steps,
            total_steps=status.total_steps,
            pushes_per_second=status.pushes_per_second,
            eta_s=status.eta_s,
            age_s=status.age_s(),
            curves=dict(self._known.curves),
            starts=self._known.starts.view,
            start_steps=self._known.start_steps.view,
            last_checkpoint=str(checkpoint) if checkpoint else "",
            revision=self._revision,
        )

    def note_request(self, state: str) -> None:
        """Show ``starting``, ``pausing`` or ``stopping`` until the trainer says something new."""
        self._asked, self._asked_at = state, time.monotonic()

    def close(self) -> None:
        """Let go of the record."""
        self._reader.close()

    def _state(self, status: RunStatus) -> str:
        is_recent = time.monotonic() - self._asked_at < _ANSWER_TIMEOUT_S
        if is_recent and status.state in _UNANSWERED.get(self._asked, ()):
            return self._asked
        self._asked = ""
        return status.state

    def _read_record(self) -> None:
        try:
            revision = self._reader.revision()
            if revision == self._record_revision:
                return
            self._read_new_rows()
        except RunError:
            # A record that is locked for a moment is read the next time; what was read stays.
            return
        self._record_revision = revision
        self._revision += 1

    def _read_new_rows(self) -> None:
        generation = self._reader.generation()
        if generation != self._known.generation:
            self._known = _ReadSoFar(generation)
        for name in self._reader.metric_names():
            steps, values = self._known.series.setdefault(
                name, (GrowingArray(np.float64), GrowingArray(np.float64))
            )
            found = self._reader.metrics_since(name, int(steps.view[-1]) if len(steps) else -1)
            steps.extend(found.steps.astype(np.float64))
            values.extend(found.values)
            if len(found.steps) or name not in self._known.curves:
                self._known.curves[name] = Curve(steps.view, values.view)
        starts = self._reader.starts_since(self._known.last_push)
        if len(starts.ids):
            self._known.last_push = int(starts.ids[-1])
            self._known.starts.extend(starts.positions)
            self._known.start_steps.extend(starts.steps)


class _ReadSoFar:
    """What has been read of a record's present generation."""

    def __init__(self, generation: int = 0) -> None:
        self.generation = generation
        self.last_push = 0
        self.series: dict[str, tuple[GrowingArray[np.float64], GrowingArray[np.float64]]] = {}
        self.curves: dict[str, Curve] = {}
        self.starts = GrowingArray(np.float32, (2,))
        self.start_steps = GrowingArray(np.int64)
