"""Settings of the PPO with a mixture of Gaussians."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int
from singulate.agents.density_ppo.config import DensityPPOConfig

MAX_COMPONENTS = 64


@dataclass(frozen=True)
class MixturePPOConfig(DensityPPOConfig):
    """Found by trial on ``random-2``: see `DensityPPOConfig` for the other settings.

    Attributes:
        num_components: K, Gaussians in the mixture. A row of two blocks can be parted by pushing
            either block from either side, and each component looks along one direction at first,
            so fewer than 8 leave a direction with one of its two sides alone.
    """

    num_components: int = 16

    def __post_init__(self) -> None:
        super().__post_init__()
        check_int("num_components", self.num_components, 1, MAX_COMPONENTS)
