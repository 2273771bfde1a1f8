"""The PPO with a mixture of Gaussians that is trained."""

from functools import partial

from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.density_ppo.model import DensityPPO, build_density_ppo, network_of
from singulate.agents.mixture_ppo.config import MixturePPOConfig
from singulate.agents.mixture_ppo.network import MixtureNet

__all__ = ["build_model", "net_maker", "network_of"]


def build_model(config: MixturePPOConfig, env: VecEnv, observation: str, seed: int) -> DensityPPO:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` actions.
        observation: Name of its observation.
        seed: Seeds the network and all random choices.
    """
    return build_density_ppo(config, env, net_maker(config), seed)


def net_maker(config: MixturePPOConfig) -> partial[MixtureNet]:
    """Builds its network from H."""
    return partial(MixtureNet, num_components=config.num_components, widths=config.net_arch)
