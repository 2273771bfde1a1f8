"""How fast a training is and when it will be done."""

import time
from collections import deque

WINDOW_S = 10.0


class SpeedMeter:
    """Pushes per second over the last ten seconds."""

    def __init__(self) -> None:
        self._samples: deque[tuple[float, int]] = deque()

    def restart(self) -> None:
        """Forget the past, after a pause."""
        self._samples.clear()

    def add(self, num_steps: int) -> None:
        """Note how many steps are done now; cheap enough for every push."""
        now = time.monotonic()
        if self._samples and now - self._samples[-1][0] < 0.1:
            return
        self._samples.append((now, num_steps))
        while now - self._samples[0][0] > WINDOW_S:
            self._samples.popleft()

    @property
    def pushes_per_second(self) -> float:
        """Current speed, 0 while unknown."""
        if len(self._samples) < 2:
            return 0.0
        (start, first), (end, last) = self._samples[0], self._samples[-1]
        return (last - first) / max(end - start, 1e-9)

    def eta_s(self, num_left: int) -> float | None:
        """Time for so many more steps [s], None while unknown."""
        speed = self.pushes_per_second
        return max(num_left, 0) / speed if speed > 0.0 else None
