"""Where an environment of a training is: what is needed to bring another one there."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Self

import numpy as np


@dataclass(frozen=True)
class EpisodeState:
    """An episode and the actions taken in it; pushes are pure, so replaying them is exact.

    The environments of a run share its episodes out: number i of `num_envs` plays episodes i,
    i + num_envs, and so on, and counts its pushes likewise, as if all were taken in turns. So
    neither scenes nor rewards depend on which process an environment lives in.

    Attributes:
        num_envs: Environments of the run.
        episode_index: Number of the episode in the run; negative before the first.
        num_pushes: Pushes of the run before the next one, which the reward's schedule counts.
        actions: Actions taken in the episode, as plain values.
    """

    num_envs: int
    episode_index: int
    num_pushes: int
    actions: tuple[Any, ...] = ()

    @classmethod
    def initial(cls, env_index: int = 0, num_envs: int = 1) -> Self:
        """Before the first episode of an environment."""
        return cls(num_envs, env_index - num_envs, env_index)

    def after_reset(self) -> Self:
        """At the beginning of the environment's next episode."""
        return type(self)(self.num_envs, self.episode_index + self.num_envs, self.num_pushes)

    def after_push(self, action: Any) -> Self:
        """After one more push of the episode."""
        actions = (*self.actions, np.asarray(action).tolist())
        num_pushes = self.num_pushes + self.num_envs
        return type(self)(self.num_envs, self.episode_index, num_pushes, actions)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """The inverse of `to_dict`."""
        return cls(
            int(values["num_envs"]),
            int(values["episode_index"]),
            int(values["num_pushes"]),
            tuple(values["actions"]),
        )
