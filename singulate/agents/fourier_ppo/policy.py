"""A trained PPO with a Fourier density, ready to push."""

from singulate.agents.density_ppo.policy import DensityPolicy
from singulate.agents.fourier_ppo.config import FourierPPOConfig
from singulate.agents.fourier_ppo.model import net_maker
from singulate.envs import EnvConfig
from singulate.geometry import Workspace


class FourierPolicy(DensityPolicy):
    """Pushes from the highest place of the series, or draws from its density."""

    kind = "fourier-ppo"


def build_policy(
    config: FourierPPOConfig, env_config: EnvConfig, workspace: Workspace | None = None
) -> FourierPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return FourierPolicy(config, net_maker(config), env_config, workspace or Workspace())
