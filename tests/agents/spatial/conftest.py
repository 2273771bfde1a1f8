import numpy as np
import pytest
import torch

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.network import ValueNetwork
from singulate.perception import distance_map


@pytest.fixture
def network() -> ValueNetwork:
    torch.manual_seed(3)
    return ValueNetwork(8, 8).eval()


@pytest.fixture
def image() -> FloatMap:
    """Distance map of one object, 6 x 13 pixels, in rows 20 to 25 and columns 30 to 42."""
    mask = np.zeros((64, 64), dtype=np.bool_)
    mask[20:26, 30:43] = True
    return distance_map(mask)


@pytest.fixture
def pointwise() -> ValueNetwork:
    """A network of 16 and 16 channels that gives 6.4 / (d + 6.4) at d pixels from an object."""
    network = ValueNetwork(16, 16).eval()
    convolutions = [layer for layer in network.layers if isinstance(layer, torch.nn.Conv2d)]
    with torch.no_grad():
        for layer in convolutions:
            layer.weight.zero_()
            layer.bias.zero_()
        # Closeness is the second of three channels of 16 pixels each; then each pixel is passed on.
        convolutions[0].weight[:, 16:32, 0, 0] = torch.eye(16)
        # Of the 9 cells along the push that are seen, the seventh is that of the start.
        for layer, row in zip(convolutions[1:4], (2, 2, 0), strict=True):
            layer.weight[:, :, row, 1] = torch.eye(16)
        for layer in convolutions[4:]:
            layer.weight[:, :, 0, 0] = torch.eye(16)
    return network
