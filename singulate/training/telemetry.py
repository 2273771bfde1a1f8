"""Where a trainer writes what happens: the run's record and TensorBoard event files."""

from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from singulate.envs.outcome_kind import outcome_kind
from singulate.runs import PushRecord, RunDirectory, RunRecord
from singulate.training.event_files import EventFiles


class Telemetry:
    """Record and event files of one run; a context manager.

    Args:
        run_dir: The run's directory, locked by this process.
        resumed_step: Where the run is continued; what lies after it is dropped. None for a new run.
    """

    def __init__(self, run_dir: Path, resumed_step: int | None = None) -> None:
        self.record = RunRecord(run_dir)
        purge_step = None if resumed_step is None else resumed_step + 1
        if resumed_step is not None:
            self.record.rewind(resumed_step)
        self._events = EventFiles(RunDirectory(run_dir).tensorboard_path, purge_step)

    def add_push(self, step: int, info: Mapping[str, Any], predicted: float | None) -> None:
        """Record a push.

        Args:
            step: Training step.
            info: What the environment said about it.
            predicted: Reward that the agent expected.

        Raises:
            RunError: If a commit was due and failed; the rows are kept for the next one.
        """
        error = info.get("simulation_error", "")
        self.record.add_push(
            PushRecord(
                step=step,
                episode=info["episode_index"],
                push=info["push"],
                reward=info["reward"],
                terms=info["reward_terms"],
                is_success=info["is_success"],
                outcome=outcome_kind(info["outcome"], info["is_success"], bool(error)),
                poses=info["poses_before"],
                predicted=predicted,
            )
        )
        if error:
            self.record.add_event("simulation_error", step=step, text=error)

    def add_metrics(self, step: int, values: Mapping[str, float]) -> None:
        """Record metrics by name.

        Raises:
            RunError: As `add_push`.
        """
        self._events.add(step, values)
        self.record.add_metrics(step, values)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._events.close()
        self.record.close()
