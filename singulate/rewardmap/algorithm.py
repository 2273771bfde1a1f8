"""What an algorithm for one level of a reward map is: the part that may be replaced."""

from collections.abc import Callable, Iterator
from typing import NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from singulate.engine import Engine
from singulate.rewardmap.request import RewardMapRequest

Cancelled = Callable[[], bool]
"""Asked often; True ends the work."""


class LevelUpdate(NamedTuple):
    """What is known of one level.

    Attributes:
        values: float32 (4, H, W), NaN where nothing is known yet; the receiver may keep it.
        progress: Share of the level's work that is done, 0 to 1; at 1 no value is NaN.
    """

    values: npt.NDArray[np.float32]
    progress: float


class LevelAlgorithm(Protocol):
    """Rewards of all pushes from the cell centres of one resolution."""

    def __call__(
        self, request: RewardMapRequest, resolution: int, engine: Engine, cancelled: Cancelled
    ) -> Iterator[LevelUpdate]:
        """Yield what is known, the last time with progress 1 unless cancelled.

        When the iterator is closed or `cancelled` answers True, its tasks are cancelled.
        """
        ...
