"""Gymnasium environments, and the task of one push that they are made of."""

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
from singulate.envs.push_env import PushEnv
from singulate.envs.push_task import PushResult, PushTask
from singulate.envs.seeding import scene_seed

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
