"""The PPO that is trained: stable-baselines3's."""

import torch
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.network import policy_arguments
from singulate.agents.ppo.config import PPOConfig


def build_model(config: PPOConfig, env: VecEnv, observation: str, seed: int) -> PPO:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` or ``start_end`` actions.
        observation: Name of its observation.
        seed: Seeds the network and all random choices.
    """
    return PPO(
        "MlpPolicy",
        env,
        learning_rate=config.learning_rate,
        n_steps=config.n_steps // env.num_envs,
        batch_size=config.batch_size,
        n_epochs=config.n_epochs,
        gamma=config.gamma,
        gae_lambda=config.gae_lambda,
        clip_range=config.clip_range,
        ent_coef=config.ent_coef,
        policy_kwargs=network_arguments(config, observation),
        seed=seed,
        device="cpu",
    )


def network_arguments(config: PPOConfig, observation: str) -> dict[str, object]:
    """Arguments of stable-baselines3's actor-critic policy."""
    widths = list(config.net_arch)
    return {
        "net_arch": {"pi": widths, "vf": list(widths)},
        "log_std_init": config.log_std_init,
        **policy_arguments(observation, adam_epsilon=1e-5, encoder=config.encoder),
    }


def network_of(model: PPO) -> torch.nn.Module:
    """The part of a model that acting needs: policy and value networks."""
    return model.policy
