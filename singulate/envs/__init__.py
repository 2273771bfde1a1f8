"""Gymnasium environments, and the task of one push that they are made of.

Bullet is loaded by the first use of `PushEnv` or `PushTask`: whoever needs configurations and
encodings alone does without it.
"""

from typing import TYPE_CHECKING, Any

from singulate.envs.actions import (
    ACTION_ENCODINGS,
    ActionEncoding,
    GridActions,
    PointActions,
    StartEndActions,
    make_action_encoding,
)
from singulate.envs.config import EnvConfig
from singulate.envs.observations import OBSERVATIONS, Observation, make_observation
from singulate.envs.seeding import scene_seed

if TYPE_CHECKING:
    from singulate.envs.push_env import PushEnv
    from singulate.envs.push_task import PushResult, PushTask

__all__ = [
    "ACTION_ENCODINGS",
    "OBSERVATIONS",
    "ActionEncoding",
    "EnvConfig",
    "GridActions",
    "Observation",
    "PointActions",
    "PushEnv",
    "PushResult",
    "PushTask",
    "StartEndActions",
    "make_action_encoding",
    "make_observation",
    "scene_seed",
]


def __getattr__(name: str) -> Any:
    if name == "PushEnv":
        from singulate.envs.push_env import PushEnv

        return PushEnv
    if name in ("PushResult", "PushTask"):
        from singulate.envs import push_task

        return getattr(push_task, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
