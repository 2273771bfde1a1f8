"""Reward of every start and direction on one scene."""

import io
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from singulate.checkpoints.durable import replace_file
from singulate.exceptions import InvalidValueError
from singulate.geometry import BlockPose, Direction, Poses

FORMAT_VERSION = 1


@dataclass(frozen=True, eq=False)
class RewardMap:
    """What is known of a scene's rewards so far.

    Attributes:
        values: float32 (4, H, W); directions up, right, down, left; row 0 is +y, column 0 is -x.
        progress: Share of the finest level that is done, 0 to 1; below 1, `values` may be of a
            coarser level or hold a coarser level's values where nothing finer is known.
        poses: The blocks at rest that it belongs to.
        reward: Name of the reward.
        goal_separation: d_goal of Eq. 2 [m].
    """

    values: npt.NDArray[np.float32]
    progress: float
    poses: Poses
    reward: str
    goal_separation: float

    @property
    def resolution(self) -> int:
        """Cells along each side of `values`."""
        return int(self.values.shape[1])

    @property
    def is_complete(self) -> bool:
        """Whether every value of the finest level is the true one."""
        return self.progress >= 1.0

    def save_npz(self, path: Path) -> None:
        """Write it as a whole or not at all, readable with `numpy.load` without pickle.

        Arrays: `reward_map` float32 (4, H, W), `directions`, `positions` (N, 3) [m], `quaternions`
        (N, 4), `sides` (N,) [m], `reward`, `goal_separation` [m], `format_version`.

        Raises:
            InvalidValueError: If the file cannot be written.
        """
        buffer = io.BytesIO()
        np.savez_compressed(
            buffer,
            reward_map=self.values,
            directions=np.array([direction.label for direction in Direction]),
            positions=np.array([pose.position for pose in self.poses]).reshape(-1, 3),
            quaternions=np.array([pose.quaternion for pose in self.poses]).reshape(-1, 4),
            sides=np.array([pose.side for pose in self.poses]),
            reward=np.array(self.reward),
            goal_separation=np.array(self.goal_separation),
            progress=np.array(self.progress),
            format_version=np.array(FORMAT_VERSION),
        )
        try:
            replace_file(path, buffer.getvalue())
        except OSError as error:
            allowed = f"a file that can be written ({error.strerror or error})"
            raise InvalidValueError("out", str(path), allowed) from None


def load_reward_map(path: Path) -> RewardMap:
    """Read what `RewardMap.save_npz` wrote.

    Raises:
        InvalidValueError: If the file cannot be read or is not a reward map.
    """
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as data:
            return _parse({name: data[name] for name in data.files})
    except (OSError, ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile) as error:
        reason = f"{type(error).__name__}: {error}".splitlines()[0]
        raise InvalidValueError("reward map", str(path), f"a saved map ({reason})") from None


def _parse(arrays: dict[str, npt.NDArray[np.generic]]) -> RewardMap:
    values = arrays["reward_map"].astype(np.float32)
    if values.ndim != 3 or values.shape[0] != 4 or values.shape[1] != values.shape[2]:
        raise ValueError(f"reward_map has the shape {values.shape}, not (4, H, H)")
    rows = zip(arrays["positions"], arrays["quaternions"], arrays["sides"], strict=True)
    return RewardMap(
        values=values,
        progress=float(arrays["progress"]),
        poses=tuple(
            BlockPose(tuple(position.tolist()), tuple(quaternion.tolist()), float(side))
            for position, quaternion, side in rows
        ),
        reward=str(arrays["reward"]),
        goal_separation=float(arrays["goal_separation"]),
    )
