"""A trained multimodal PPO, ready to push."""

from singulate.agents.density_ppo.policy import DensityPolicy
from singulate.agents.multimodal_ppo.config import MultimodalPPOConfig
from singulate.agents.multimodal_ppo.model import net_maker
from singulate.envs import EnvConfig
from singulate.geometry import Workspace


class MultimodalPolicy(DensityPolicy):
    """Pushes from the likeliest cell, or draws from a density with many modes.

    The greedy push keeps to one cell: a mean over a region falls between two modes, such as the two
    sides of a seam, and there on the seam itself (96 % instead of 99 % on ``random-2``).
    """

    kind = "multimodal-ppo"


def build_policy(
    config: MultimodalPPOConfig, env_config: EnvConfig, workspace: Workspace | None = None
) -> MultimodalPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return MultimodalPolicy(config, net_maker(config), env_config, workspace or Workspace())
