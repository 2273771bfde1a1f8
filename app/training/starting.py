"""What a person asked to train: a checked configuration."""

from collections.abc import Mapping
from typing import Any

from app.commands import StartTraining
from singulate.agents.registry import agent_kind
from singulate.envs.config import EnvConfig
from singulate.exceptions import InvalidValueError
from singulate.training.config import TrainingConfig

_CHECKPOINTS_A_RUN = 50
_FEWEST_PUSHES, _MOST_PUSHES = 20, 1_000
"""Between checkpoints: those of a run that is watched come often, so that its policy can be
followed."""


def training_config(command: StartTraining) -> TrainingConfig:
    """The checked configuration that a person asked for.

    Args:
        command: `options` may hold ``env`` and ``agent_config``, objects with keys, and any other
            field of `TrainingConfig`.

    Raises:
        InvalidValueError: If a key is unknown or a value is not allowed.
    """
    options = dict(command.options)
    env = {
        "scenario": command.scenario,
        "action": agent_kind(command.agent).actions[0],
        **_mapping("env", options.pop("env", {})),
    }
    return TrainingConfig.from_dict(
        {
            "checkpoint_every": _checkpoint_every(command.total_timesteps),
            **options,
            "agent": command.agent,
            "env": EnvConfig.from_dict(env).to_dict(),
            "total_timesteps": command.total_timesteps,
            "seed": command.seed,
        }
    )


def _checkpoint_every(total_timesteps: int) -> int:
    return min(max(_FEWEST_PUSHES, total_timesteps // _CHECKPOINTS_A_RUN), _MOST_PUSHES)


def _mapping(key: str, value: object) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise InvalidValueError(key, value, "an object with keys")
    return value
