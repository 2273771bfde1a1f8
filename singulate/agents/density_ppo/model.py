"""The PPO that is trained: stable-baselines3's, with another actor and schedules."""

from collections.abc import Callable
from typing import Any

import torch
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.annealing import annealed, set_learning_rate
from singulate.agents.density_ppo.actor_critic import DensityActorCritic
from singulate.agents.density_ppo.config import DensityPPOConfig
from singulate.agents.density_ppo.network import TurnedNet


class DensityPPO(PPO):
    """PPO whose step size and entropy bonus depend on the number of pushes alone."""

    def __init__(self, *args: Any, config: DensityPPOConfig, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.config = config

    def train(self) -> None:
        """Update actor and critic on the pushes of one rollout."""
        self.ent_coef = self._annealed(self.config.ent_coef, self.config.final_ent_coef)
        super().train()

    def _update_learning_rate(
        self, optimizers: list[torch.optim.Optimizer] | torch.optim.Optimizer
    ) -> None:
        rate = self._annealed(self.config.learning_rate, self.config.final_learning_rate)
        set_learning_rate(self, optimizers, rate)

    def _annealed(self, start: float, end: float) -> float:
        return annealed(start, end, self.num_timesteps, self.config.anneal_steps)


def build_density_ppo(
    config: DensityPPOConfig, env: VecEnv, make_net: Callable[[int], TurnedNet], seed: int
) -> DensityPPO:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` actions.
        make_net: Builds its network from H, pixels along each side of an observation.
        seed: Seeds the network and all random choices.
    """
    return DensityPPO(
        DensityActorCritic,
        env,
        config=config,
        learning_rate=config.learning_rate,
        n_steps=config.n_steps // env.num_envs,
        batch_size=config.batch_size,
        n_epochs=config.n_epochs,
        gamma=config.gamma,
        gae_lambda=config.gae_lambda,
        clip_range=config.clip_range,
        vf_coef=config.vf_coef,
        max_grad_norm=config.max_grad_norm,
        policy_kwargs=actor_critic_arguments(make_net),
        seed=seed,
        device="cpu",
    )


def actor_critic_arguments(make_net: Callable[[int], TurnedNet]) -> dict[str, Any]:
    """Arguments of the actor and critic."""
    return {
        "make_net": make_net,
        "normalize_images": False,
        "optimizer_kwargs": {"eps": 1e-5, "fused": True},
    }


def network_of(model: PPO) -> torch.nn.Module:
    """The part of a model that acting needs: actor and critic."""
    return model.policy
