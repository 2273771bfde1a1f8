"""Everything that decides a training run."""

import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import Any, Self

from singulate.agents.config_fields import check_int
from singulate.agents.encoder_setting import check_encoder_fits
from singulate.agents.registry import AgentConfig, AgentKind, agent_kind
from singulate.envs import EnvConfig
from singulate.exceptions import InvalidValueError

MAX_SEED = 2**32 - 1
MAX_ENVS = 256


@dataclass(frozen=True)
class TrainingConfig:
    """A run's settings; two runs with equal settings are equal, bit for bit.

    Attributes:
        agent: Kind of agent (a key of `AGENTS`).
        env: The environment.
        total_timesteps: Pushes to train for.
        seed: Decides the network, all random choices and all scenes.
        agent_config: The agent's settings by name; absent ones take their defaults. One that is
            None is left out, so that runs that do without it have the hashes that they had before
            there was such a setting.
        checkpoint_every: Pushes between checkpoints.
        num_checkpoints: Checkpoints that are kept; older ones are removed.
        num_threads: Threads of torch.
        dataset: Directory of a data set to learn from instead of the simulation; None for none.
        dataset_sha256: Hash of its content, which has to fit.
        num_envs: Environments that push at the same time; the total of pushes, the pushes between
            two updates of PPO or TRPO and the updates a push of all others stay the same.
        num_workers: Processes that the environments live in, which changes nothing but the speed;
            0 is the trainer's own. None is 0 for a single environment or a data set, else one a
            core.

    Raises:
        InvalidValueError: If a value is not allowed, or the agent cannot use the action encoding.
    """

    agent: str
    env: EnvConfig
    total_timesteps: int
    seed: int = 0
    agent_config: Mapping[str, Any] = field(default_factory=dict)
    checkpoint_every: int = 5_000
    num_checkpoints: int = 5
    num_threads: int = 1
    dataset: str | None = None
    dataset_sha256: str | None = None
    num_envs: int = 1
    num_workers: int | None = None

    def __post_init__(self) -> None:
        if self.env.action not in self.kind.actions:
            raise InvalidValueError(
                "action", self.env.action, f"{', '.join(self.kind.actions)} for {self.agent}"
            )
        for key in ("dataset", "dataset_sha256"):
            value = getattr(self, key)
            if not isinstance(value, str | None):
                raise InvalidValueError(key, value, "a text, or null")
        check_int("steps", self.total_timesteps, 1, 1_000_000_000)
        check_int("seed", self.seed, 0, MAX_SEED)
        check_int("checkpoint_every", self.checkpoint_every, 1, 1_000_000_000)
        check_int("num_checkpoints", self.num_checkpoints, 1, 10_000)
        check_int("num_threads", self.num_threads, 1, 256)
        resolved = _settings_in_use(self.kind.make_config(self.agent_config))
        resolved["net_arch"] = list(resolved["net_arch"])
        object.__setattr__(self, "agent_config", resolved)
        check_encoder_fits(resolved, self.env.observation)
        self._check_envs(resolved.get("n_steps"))

    @property
    def kind(self) -> AgentKind:
        """The agent's entry in the registry."""
        return agent_kind(self.agent)

    @property
    def resolved_agent_config(self) -> AgentConfig:
        """The agent's settings, checked."""
        return self.kind.make_config(self.agent_config)

    @property
    def resolved_num_workers(self) -> int:
        """Processes for the environments, with the default filled in."""
        if self.num_workers is not None:
            return self.num_workers
        return 0 if self.num_envs == 1 or self.dataset else min(self.num_envs, os.cpu_count() or 1)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON, every default filled in."""
        values = {item.name: getattr(self, item.name) for item in fields(self)}
        return {**values, "env": self.env.to_dict(), "agent_config": dict(self.agent_config)}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """The inverse of `to_dict`.

        Raises:
            InvalidValueError: If a key is unknown or missing, or a value is not allowed.
        """
        if not isinstance(values, Mapping):
            raise InvalidValueError("training configuration", values, "an object with keys")
        names = [item.name for item in fields(cls)]
        for key in values:
            if key not in names:
                raise InvalidValueError(key, values[key], "one of " + ", ".join(names))
        for key in ("agent", "env", "total_timesteps"):
            if key not in values:
                raise InvalidValueError(key, None, "a value, it is missing")
        if not isinstance(values["env"], Mapping):
            raise InvalidValueError("env", values["env"], "an object with keys")
        return cls(**{**values, "env": EnvConfig.from_dict(values["env"])})

    def _check_envs(self, n_steps: int | None) -> None:
        check_int("num_envs", self.num_envs, 1, MAX_ENVS)
        if n_steps is not None and n_steps % self.num_envs:
            raise InvalidValueError("num_envs", self.num_envs, f"a divisor of n_steps ({n_steps})")
        if self.num_workers is not None:
            highest = 0 if self.dataset else self.num_envs  # a data set needs no workers
            check_int("num_workers", self.num_workers, 0, highest)


def _settings_in_use(config: AgentConfig) -> dict[str, Any]:
    return {name: value for name, value in asdict(config).items() if value is not None}
