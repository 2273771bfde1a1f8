"""A trained PPO, ready to push."""

from singulate.agents.gaussian.policy import GaussianPolicy
from singulate.agents.ppo.config import PPOConfig
from singulate.envs import EnvConfig


def build_policy(config: PPOConfig, env_config: EnvConfig) -> GaussianPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return GaussianPolicy("ppo", config, env_config)
