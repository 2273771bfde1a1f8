"""The SAC that is trained: stable-baselines3's, with an exploration that can be resumed."""

import numpy as np
import torch
from stable_baselines3 import SAC
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.off_policy.algorithm import Actions, ActorCriticUpdates
from singulate.agents.off_policy.networks import ActorAndCritics, network_arguments
from singulate.agents.overlap import OverlappedSteps
from singulate.agents.replay import SeededReplayBuffer
from singulate.agents.sac.config import SACConfig


class PushSAC(ActorCriticUpdates, SAC):
    """SAC that tries what it draws from its squashed Gaussian."""

    @property
    def optimizers(self) -> dict[str, torch.optim.Optimizer]:
        """Every optimizer that training goes on with, by name."""
        assert self.ent_coef_optimizer is not None
        return {**super().optimizers, "entropy_optimizer": self.ent_coef_optimizer}

    @property
    def extra_tensors(self) -> dict[str, torch.Tensor]:
        """What is learnt beside the networks, by name."""
        assert self.log_ent_coef is not None
        return {"log_ent_coef": self.log_ent_coef}

    def update(self, gradient_steps: int) -> None:
        """Improve actor, critics and the entropy's weight by so many gradient steps."""
        SAC.train(self, gradient_steps, self.batch_size)

    def explore(self, observations: torch.Tensor) -> Actions:
        """Actions drawn from the squashed Gaussian, float32 (batch, dims)."""
        mean, log_std, _ = self.actor.get_action_dist_params(observations)
        drawn = self.exploration_rng.normal(mean.numpy(), log_std.exp().numpy())
        return np.tanh(drawn).astype(np.float32)


def build_model(config: SACConfig, env: VecEnv, observation: str, seed: int) -> PushSAC:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` or ``start_end`` actions.
        observation: Name of its observation.
        seed: Seeds the networks and all random choices.
    """
    steps = OverlappedSteps(env) if env.num_envs > 1 else env
    shape = env.action_space.shape
    assert shape is not None
    model = PushSAC(
        "MlpPolicy",
        steps,
        learning_rate=config.learning_rate,
        buffer_size=config.buffer_size,
        learning_starts=config.learning_starts,
        batch_size=config.batch_size,
        tau=config.tau,
        gamma=config.gamma,
        train_freq=1,
        gradient_steps=config.gradient_steps * env.num_envs,
        replay_buffer_class=SeededReplayBuffer,
        replay_buffer_kwargs={"seed": seed},
        ent_coef=f"auto_{config.initial_ent_coef}",
        target_entropy=config.target_entropy * shape[0],
        policy_kwargs=network_arguments(config.net_arch, observation),
        seed=seed,
        device="cpu",
    )
    if isinstance(steps, OverlappedSteps):
        steps.meanwhile = model.update_meanwhile
    return model


def network_of(model: PushSAC) -> torch.nn.Module:
    """The part of a model that acting and judging pushes need."""
    return ActorAndCritics(model.policy)
