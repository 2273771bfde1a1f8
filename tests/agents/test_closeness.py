import pytest
import torch

from singulate.agents.closeness import closeness


def test_closeness_is_half_where_the_start_reward_peaks() -> None:
    images = torch.tensor([-1.0, 0.0, 6.4, 1e9])
    assert closeness(images).tolist() == pytest.approx([1.0, 1.0, 0.5, 0.0], abs=1e-6)
