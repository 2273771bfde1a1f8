"""A trained PPO with a mixture of Gaussians, ready to push."""

from singulate.agents.density_ppo.policy import DensityPolicy
from singulate.agents.mixture_ppo.config import MixturePPOConfig
from singulate.agents.mixture_ppo.model import net_maker
from singulate.envs import EnvConfig
from singulate.geometry import Workspace


class MixturePolicy(DensityPolicy):
    """Pushes from the densest component's mean, or draws from the mixture."""

    kind = "mixture-ppo"


def build_policy(
    config: MixturePPOConfig, env_config: EnvConfig, workspace: Workspace | None = None
) -> MixturePolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return MixturePolicy(config, net_maker(config), env_config, workspace or Workspace())
