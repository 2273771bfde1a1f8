"""The network: coefficients of a cosine series for each direction."""

from typing import NamedTuple

import torch

from singulate.agents.density_ppo.cells import PushCells
from singulate.agents.density_ppo.network import TurnedNet
from singulate.agents.density_ppo.turning import turn_back
from singulate.agents.fourier_ppo.config import HEAD_CELLS
from singulate.agents.fourier_ppo.distribution import FourierDistribution
from singulate.agents.fourier_ppo.series import coefficients_of


class FourierMaps(NamedTuple):
    """What the network says about a batch of scenes.

    Attributes:
        cells: The grid on which the density is normalised.
        coefficients: Of the series of each direction, by frequency along -y and x,
            (batch, 4, M, M).
        values: Expected (scaled) rewards, (batch, 1).
    """

    cells: PushCells
    coefficients: torch.Tensor
    values: torch.Tensor

    def distribution(self) -> FourierDistribution:
        """Densities of pushes."""
        return FourierDistribution(self.cells).proba_distribution(self.coefficients)


class FourierNet(TurnedNet):
    """Says `FourierMaps`.

    The coefficients are those of a map that the convolutions make: its projection on the first
    cosines. A fully connected layer would have to learn at each place anew how a block's position
    turns into phases; here the same features give the same modes wherever they are. The map is
    made higher by what the projection takes from a single peak, so that steps of learning are felt
    alike however many cosines there are.

    Args:
        image_size: H, pixels along each side of an observation.
        num_cells: Cells along each side of the grid.
        num_frequencies: M.
        widths: Channels of the convolutions.
    """

    def __init__(
        self, image_size: int, num_cells: int, num_frequencies: int, widths: tuple[int, ...]
    ) -> None:
        super().__init__(image_size, HEAD_CELLS, widths, num_channels=1)
        self._cells = PushCells(num_cells)
        self._num_frequencies = num_frequencies
        self._gain = (HEAD_CELLS / num_frequencies) ** 2

    def forward(self, observations: torch.Tensor) -> FourierMaps:
        """Look at observations, (batch, H, H)."""
        heads, values = self.look(observations)
        maps = self._gain * turn_back(heads)[:, :, 0]
        return FourierMaps(self._cells, coefficients_of(maps, self._num_frequencies), values)
