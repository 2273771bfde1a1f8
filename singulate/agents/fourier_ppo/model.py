"""The PPO with a Fourier density that is trained."""

from functools import partial

from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.density_ppo.model import DensityPPO, build_density_ppo, network_of
from singulate.agents.fourier_ppo.config import FourierPPOConfig
from singulate.agents.fourier_ppo.network import FourierNet

__all__ = ["build_model", "net_maker", "network_of"]


def build_model(config: FourierPPOConfig, env: VecEnv, observation: str, seed: int) -> DensityPPO:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` actions.
        observation: Name of its observation.
        seed: Seeds the network and all random choices.
    """
    return build_density_ppo(config, env, net_maker(config), seed)


def net_maker(config: FourierPPOConfig) -> partial[FourierNet]:
    """Builds its network from H."""
    return partial(
        FourierNet,
        num_cells=config.num_cells,
        num_frequencies=config.num_frequencies,
        widths=config.net_arch,
    )
