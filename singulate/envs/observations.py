"""What an agent sees of the camera's picture."""

from collections.abc import Callable
from typing import Protocol

import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from singulate.exceptions import InvalidValueError
from singulate.geometry import Workspace
from singulate.perception import Percept


class Observation(Protocol):
    """An observation space and how it is filled."""

    @property
    def space(self) -> spaces.Box:
        """float32 (H, W) and its bounds."""
        ...

    def observe(self, percept: Percept) -> npt.NDArray[np.float32]:
        """The observation, float32 (H, W)."""
        ...


class DistanceMapObservation:
    """Pixels to the closest object, -1 inside (paper, section 3.1)."""

    def __init__(self, workspace: Workspace) -> None:
        size = workspace.image_size
        self.space = spaces.Box(-1.0, float(np.hypot(size, size)), (size, size), np.float32)

    def observe(self, percept: Percept) -> npt.NDArray[np.float32]:
        """See `Observation.observe`."""
        return percept.distance_map.copy()


class MaskObservation:
    """1 where an object is, 0 elsewhere: the paper's baseline state (section 5)."""

    def __init__(self, workspace: Workspace) -> None:
        size = workspace.image_size
        self.space = spaces.Box(0.0, 1.0, (size, size), np.float32)

    def observe(self, percept: Percept) -> npt.NDArray[np.float32]:
        """See `Observation.observe`."""
        return percept.mask.astype(np.float32)


OBSERVATIONS: dict[str, Callable[[Workspace], Observation]] = {
    "distance_map": DistanceMapObservation,
    "mask": MaskObservation,
}


def make_observation(name: str, workspace: Workspace) -> Observation:
    """Look an observation up by name.

    Raises:
        InvalidValueError: If there is no such observation.
    """
    if name not in OBSERVATIONS:
        raise InvalidValueError("observation", name, ", ".join(OBSERVATIONS))
    return OBSERVATIONS[name](workspace)
