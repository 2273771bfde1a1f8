"""TensorBoard event files, a convenience that never ends a training."""

import contextlib
from collections.abc import Mapping
from pathlib import Path

from torch.utils.tensorboard import SummaryWriter


class EventFiles:
    """Writes metrics for TensorBoard; what a full disk refuses is left out.

    The run's record holds the same metrics, and it keeps them until they can be written.

    Args:
        directory: Where the files go.
        purge_step: What earlier files hold from this step on is void.
    """

    def __init__(self, directory: Path, purge_step: int | None) -> None:
        self._directory = directory
        self._purge_step = purge_step
        self._writer: SummaryWriter | None = None

    def add(self, step: int, values: Mapping[str, float]) -> None:
        """Write values of a training step by name; a writer that failed is replaced."""
        try:
            if self._writer is None:
                self._writer = SummaryWriter(str(self._directory), purge_step=self._purge_step)
                self._purge_step = None
            for name, value in values.items():
                self._writer.add_scalar(name, value, step)
        except OSError:
            self.close()

    def close(self) -> None:
        """Write what is waiting and close the file."""
        writer, self._writer = self._writer, None
        if writer is not None:
            with contextlib.suppress(OSError):
                writer.close()
