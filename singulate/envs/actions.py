"""How an agent's action becomes a push."""

from collections.abc import Callable
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from singulate.exceptions import InvalidValueError
from singulate.geometry import Direction, Push, Workspace


class ActionEncoding(Protocol):
    """An action space and its meaning."""

    @property
    def space(self) -> spaces.Space[Any]:
        """The actions that an agent may emit."""
        ...

    def decode(self, action: Any) -> Push:
        """The push that an action stands for.

        Raises:
            InvalidValueError: If the action is not in the space.
        """
        ...

    def encode(self, push: Push) -> Any:
        """The action that comes closest to a push; the inverse of `decode` where there is one."""
        ...


class GridActions:
    """Discrete(400): direction * 100 + row * 10 + column, from a 10 x 10 grid of cell centres.

    The paper's discretisation for Deep Q-Learning (section 5.4).
    """

    resolution = 10

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self.space = spaces.Discrete(len(Direction) * self.resolution**2)

    def decode(self, action: Any) -> Push:
        """See `ActionEncoding.decode`."""
        index = _integer(action, int(self.space.n))
        direction, cell = divmod(index, self.resolution**2)
        row, col = divmod(cell, self.resolution)
        start = self._workspace.row_col_to_xy(row, col, self.resolution)
        return Push.cardinal(start, Direction(direction), self._workspace.push_length)

    def encode(self, push: Push) -> int:
        """See `ActionEncoding.encode`."""
        row, col = self._workspace.xy_to_row_col(*push.start, self.resolution)
        return int(push.nearest_direction) * self.resolution**2 + row * self.resolution + col


class PointActions:
    """Box(-1, 1, (3,)): x / l, y / l and c, where four equal bins of c pick the direction.

    The paper's a = (x, y, c) (section 3.2.2).
    """

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self.space = spaces.Box(-1.0, 1.0, (3,), np.float32)

    def decode(self, action: Any) -> Push:
        """See `ActionEncoding.decode`."""
        x, y, c = _vector(action, 3)
        direction = Direction(min(int((c + 1.0) * 2.0), 3))
        half = self._workspace.half_length
        return Push.cardinal((x * half, y * half), direction, self._workspace.push_length)

    def encode(self, push: Push) -> npt.NDArray[np.float32]:
        """See `ActionEncoding.encode`."""
        half = self._workspace.half_length
        c = (push.nearest_direction + 0.5) / 2.0 - 1.0
        return _to_box([push.start[0] / half, push.start[1] / half, c])


class StartEndActions:
    """Box(-1, 1, (4,)): start and end of the push, each divided by l.

    The baseline action of the paper (section 5).
    """

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self.space = spaces.Box(-1.0, 1.0, (4,), np.float32)

    def decode(self, action: Any) -> Push:
        """See `ActionEncoding.decode`."""
        half = self._workspace.half_length
        x0, y0, x1, y1 = (half * value for value in _vector(action, 4))
        return Push.between((x0, y0), (x1, y1))

    def encode(self, push: Push) -> npt.NDArray[np.float32]:
        """See `ActionEncoding.encode`."""
        return _to_box([value / self._workspace.half_length for value in (*push.start, *push.end)])


ACTION_ENCODINGS: dict[str, Callable[[Workspace], ActionEncoding]] = {
    "grid": GridActions,
    "point": PointActions,
    "start_end": StartEndActions,
}


def make_action_encoding(name: str, workspace: Workspace) -> ActionEncoding:
    """Look an action encoding up by name.

    Raises:
        InvalidValueError: If there is no such encoding.
    """
    if name not in ACTION_ENCODINGS:
        raise InvalidValueError("action", name, ", ".join(ACTION_ENCODINGS))
    return ACTION_ENCODINGS[name](workspace)


def _integer(action: Any, count: int) -> int:
    value = np.asarray(action)
    if value.size != 1 or not np.issubdtype(value.dtype, np.integer):
        raise InvalidValueError("action", action, f"one integer from 0 to {count - 1}")
    index = int(value.reshape(()))
    if not 0 <= index < count:
        raise InvalidValueError("action", index, f"0 to {count - 1}")
    return index


def _to_box(values: list[float]) -> npt.NDArray[np.float32]:
    return np.clip(np.array(values, dtype=np.float32), -1.0, 1.0)


def _vector(action: Any, size: int) -> list[float]:
    try:
        value: npt.NDArray[np.float64] = np.asarray(action, dtype=np.float64)
    except (TypeError, ValueError):
        raise InvalidValueError("action", action, f"{size} numbers from -1 to 1") from None
    numbers: list[float] = value.ravel().tolist()
    if value.shape != (size,) or not all(abs(number) <= 1.0 for number in numbers):
        raise InvalidValueError("action", action, f"{size} numbers from -1 to 1")
    return numbers
