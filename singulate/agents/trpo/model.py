"""The TRPO that is trained: sb3-contrib's."""

import torch
from sb3_contrib import TRPO
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.gaussian.networks import network_arguments
from singulate.agents.trpo.config import TRPOConfig


def build_model(config: TRPOConfig, env: VecEnv, observation: str, seed: int) -> TRPO:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` or ``start_end`` actions.
        observation: Name of its observation.
        seed: Seeds the network and all random choices.
    """
    return TRPO(
        "MlpPolicy",
        env,
        learning_rate=config.learning_rate,
        n_steps=config.n_steps // env.num_envs,
        batch_size=config.batch_size,
        n_critic_updates=config.n_critic_updates,
        gamma=config.gamma,
        gae_lambda=config.gae_lambda,
        target_kl=config.target_kl,
        cg_max_steps=config.cg_max_steps,
        cg_damping=config.cg_damping,
        policy_kwargs=network_arguments(config, observation),
        seed=seed,
        device="cpu",
    )


def network_of(model: TRPO) -> torch.nn.Module:
    """The part of a model that acting needs: policy and value networks."""
    return model.policy
