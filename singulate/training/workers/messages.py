"""What a trainer and a worker with environments say to each other over their pipe."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from singulate.envs import EnvConfig
from singulate.training.episode_state import EpisodeState

Observation = npt.NDArray[np.float32]


class Settings(NamedTuple):
    """Trainer to worker, once: the environments to make."""

    env: EnvConfig
    run_seed: int


class Restore(NamedTuple):
    """Trainer to worker: bring an environment to a state; answered by `Restored`."""

    env_index: int
    state: EpisodeState


class Act(NamedTuple):
    """Trainer to worker: push; answered by `Acted`.

    Where `loss` says why the push was lost, it is not simulated: the episode is truncated.
    """

    env_index: int
    action: Any
    loss: str = ""


class Restored(NamedTuple):
    """Worker to trainer: an environment is where it was asked to be."""

    env_index: int
    observation: Observation


class Acted(NamedTuple):
    """Worker to trainer: what came of a push.

    `observation` is that of the next episode where this one `is_done`; its own last one is then in
    ``info["terminal_observation"]``, as stable-baselines3 wants it.
    """

    env_index: int
    observation: Observation
    reward: float
    is_done: bool
    info: dict[str, Any]


class Failed(NamedTuple):
    """Worker to trainer: an exception, one line; the worker ends."""

    text: str


Request = Restore | Act
Answer = Restored | Acted | Failed
