"""Ends workers that no longer answer."""

import threading
from collections.abc import Sequence

from singulate.training.workers.env_worker import EnvWorker

HANG_TIMEOUT_S = 5.0
"""A push takes milliseconds; a worker that takes so long over one is stopped or hung [s]."""

START_TIMEOUT_S = 60.0
"""The same for its first answer [s]."""

_TICK_S = 0.1


class Watchdog(threading.Thread):
    """Kills a worker that is waited for and gives no sign of life: stopped, hung, or half dead.

    A thread does it, because the trainer may wait for the second half of a message. It counts its
    own ticks, so the time in which the trainer itself was stopped does not count.

    Args:
        workers: Whom to watch; the owner replaces them in this list.

    Attributes:
        is_waiting: Whether the trainer waits; silence while it does something else is no fault.
    """

    def __init__(self, workers: Sequence[EnvWorker]) -> None:
        super().__init__(name="watchdog", daemon=True)
        self._workers = workers
        self._limits_s = (START_TIMEOUT_S, HANG_TIMEOUT_S)
        self._is_closing = threading.Event()
        self.is_waiting = False

    def run(self) -> None:
        """Watch until closed."""
        seen: dict[EnvWorker, tuple[int, int]] = {}
        while not self._is_closing.wait(_TICK_S):
            seen = {worker: self._look_at(worker, seen) for worker in list(self._workers)}

    def close(self) -> None:
        """End the thread."""
        self._is_closing.set()
        self.join()

    def _look_at(
        self, worker: EnvWorker, seen: dict[EnvWorker, tuple[int, int]]
    ) -> tuple[int, int]:
        """Signs of life and ticks of silence since the last one; kills where it is too long."""
        num_signs, num_silent = seen.get(worker, (-1, 0))
        if num_signs != worker.num_signs or not self.is_waiting or not worker.num_unanswered:
            return worker.num_signs, 0
        num_silent += 1
        limit_s = self._limits_s[worker.has_answered]
        if num_silent * _TICK_S >= limit_s:
            worker.kill(f"gave no answer for {limit_s:g} s")
        return num_signs, num_silent
