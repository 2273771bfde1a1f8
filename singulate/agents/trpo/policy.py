"""A trained TRPO, ready to push."""

from singulate.agents.gaussian.policy import GaussianPolicy
from singulate.agents.trpo.config import TRPOConfig
from singulate.envs import EnvConfig


def build_policy(config: TRPOConfig, env_config: EnvConfig) -> GaussianPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return GaussianPolicy("trpo", config, env_config)
