"""Settings of the PPO with a Fourier density."""

from dataclasses import dataclass

from singulate.agents.config_fields import check_int
from singulate.agents.density_ppo.config import DensityPPOConfig
from singulate.exceptions import InvalidValueError

HEAD_CELLS = 32
"""Cells along each side on which the network makes the map whose coefficients are taken."""


@dataclass(frozen=True)
class FourierPPOConfig(DensityPPOConfig):
    """Chosen without a search; see `DensityPPOConfig` for the other settings.

    Attributes:
        num_frequencies: Cosines along each axis, the constant included; the shortest half-wave is
            2 l / (num_frequencies - 1).
        num_cells: Cells along each side of the grid on which the density is normalised and within
            whose cells it is constant; a divisor of the 64 pixels.
    """

    num_frequencies: int = 24
    num_cells: int = 64

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.num_cells not in (16, 32, 64):
            raise InvalidValueError("num_cells", self.num_cells, "16, 32 or 64")
        check_int("num_frequencies", self.num_frequencies, 2, min(HEAD_CELLS, self.num_cells))
