"""Worker processes on this machine."""

import os

from singulate.engine.dispatched_engine import DispatchedEngine, check_workers
from singulate.engine.dispatcher import Dispatcher


class LocalEngine(DispatchedEngine):
    """An `Engine` of spawned, niced, watched processes that die with this one.

    Args:
        num_workers: Processes; one a core by default.
        niceness: How far the workers stand back behind this process (0 to 19).
        hang_timeout_s: A worker that takes longer over one task is replaced, like a dead one.
        cancel_grace_s: A worker that is still busy with a cancelled task after this is replaced.

    Raises:
        InvalidValueError: If a value is out of range.

    Example:
        >>> import operator
        >>> with LocalEngine(num_workers=1) as engine:
        ...     batch = engine.submit(operator.add, [1, 2], tool=int)
        ...     sorted(result.value for result in batch)
        [1, 2]
    """

    def __init__(
        self,
        num_workers: int | None = None,
        *,
        niceness: int = 15,
        hang_timeout_s: float = 120.0,
        cancel_grace_s: float = 10.0,
    ) -> None:
        if num_workers is None:
            num_workers = os.cpu_count() or 1
        check_workers(num_workers, niceness)
        self._dispatcher = Dispatcher(num_workers, niceness, hang_timeout_s, cancel_grace_s)
        super().__init__(num_workers, self._dispatcher)

    @property
    def pids(self) -> list[int]:
        """Process ids of the workers; a replaced one has another."""
        return self._dispatcher.pids

    @property
    def has_failed(self) -> bool:
        """Whether it refuses all work for good, because its workers end before they are ready."""
        return self._dispatcher.has_failed
