"""The kinds of agents that can be trained. To add one: one folder and one line here.

The folder holds ``config.py`` (a dataclass that checks itself, without torch), ``model.py``
(`build_model`, `network_of`) and ``policy.py`` (`build_policy`).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

from singulate.agents.config_fields import config_from_dict
from singulate.agents.dqn.config import DQNConfig
from singulate.agents.fourier_ppo.config import FourierPPOConfig
from singulate.agents.mixture_ppo.config import MixturePPOConfig
from singulate.agents.multimodal_ppo.config import MultimodalPPOConfig
from singulate.agents.policy import Policy
from singulate.agents.ppo.config import PPOConfig
from singulate.agents.sac.config import SACConfig
from singulate.agents.spatial.config import SpatialConfig
from singulate.agents.td3.config import TD3Config
from singulate.agents.trpo.config import TRPOConfig
from singulate.exceptions import InvalidValueError

if TYPE_CHECKING:
    import torch
    from stable_baselines3.common.base_class import BaseAlgorithm
    from stable_baselines3.common.vec_env import VecEnv

    from singulate.envs import EnvConfig

AgentConfig = (
    DQNConfig
    | PPOConfig
    | SpatialConfig
    | MultimodalPPOConfig
    | MixturePPOConfig
    | FourierPPOConfig
    | TRPOConfig
    | SACConfig
    | TD3Config
)


@dataclass(frozen=True)
class AgentKind:
    """How to configure, build and load one kind of agent.

    Attributes:
        name: What users call it.
        config_class: Its settings.
        actions: Action encodings that it can use, the paper's first.
        package: Where its model and policy are.
    """

    name: str
    config_class: type[Any]
    actions: tuple[str, ...]
    package: str

    def make_config(self, values: Mapping[str, Any]) -> AgentConfig:
        """Settings from plain values; raises InvalidValueError on unknown keys and bad values."""
        config: AgentConfig = config_from_dict(self.config_class, values, self.name)
        return config

    def build_model(
        self, config: AgentConfig, env: "VecEnv", observation: str, seed: int
    ) -> "BaseAlgorithm":
        """An untrained stable-baselines3 model."""
        model: BaseAlgorithm = self._module("model").build_model(config, env, observation, seed)
        return model

    def network_of(self, model: "BaseAlgorithm") -> "torch.nn.Module":
        """The part of a model that its policy needs."""
        network: torch.nn.Module = self._module("model").network_of(model)
        return network

    def build_policy(
        self, config: AgentConfig, env_config: "EnvConfig"
    ) -> tuple[Policy, "torch.nn.Module"]:
        """A policy with untrained weights, and the network to load trained ones into."""
        policy = self._module("policy").build_policy(config, env_config)
        return policy, policy.network

    def _module(self, name: str) -> Any:
        return import_module(f"{self.package}.{name}")


AGENTS: dict[str, AgentKind] = {
    "dqn": AgentKind("dqn", DQNConfig, ("grid",), "singulate.agents.dqn"),
    "ppo": AgentKind("ppo", PPOConfig, ("point", "start_end"), "singulate.agents.ppo"),
    "spatial": AgentKind("spatial", SpatialConfig, ("point",), "singulate.agents.spatial"),
    "multimodal-ppo": AgentKind(
        "multimodal-ppo", MultimodalPPOConfig, ("point",), "singulate.agents.multimodal_ppo"
    ),
    "mixture-ppo": AgentKind(
        "mixture-ppo", MixturePPOConfig, ("point",), "singulate.agents.mixture_ppo"
    ),
    "fourier-ppo": AgentKind(
        "fourier-ppo", FourierPPOConfig, ("point",), "singulate.agents.fourier_ppo"
    ),
    "trpo": AgentKind("trpo", TRPOConfig, ("point", "start_end"), "singulate.agents.trpo"),
    "sac": AgentKind("sac", SACConfig, ("point", "start_end"), "singulate.agents.sac"),
    "td3": AgentKind("td3", TD3Config, ("point", "start_end"), "singulate.agents.td3"),
}


def agent_kind(name: object) -> AgentKind:
    """Look up a kind of agent.

    Raises:
        InvalidValueError: If there is none of that name.
    """
    if not isinstance(name, str) or name not in AGENTS:
        raise InvalidValueError("agent", name, ", ".join(AGENTS))
    return AGENTS[name]
