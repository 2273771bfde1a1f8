"""Settings of the multimodal PPO agent."""

from dataclasses import dataclass

from singulate.agents.density_ppo.config import DensityPPOConfig
from singulate.exceptions import InvalidValueError


@dataclass(frozen=True)
class MultimodalPPOConfig(DensityPPOConfig):
    """Found by trial on ``random-2``: see `DensityPPOConfig` for the other settings.

    Attributes:
        num_cells: Cells along each side of the workspace; a divisor of the 64 pixels.
    """

    num_cells: int = 32

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.num_cells not in (4, 8, 16, 32):
            raise InvalidValueError("num_cells", self.num_cells, "4, 8, 16 or 32")
