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
