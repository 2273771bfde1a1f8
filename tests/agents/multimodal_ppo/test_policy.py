import numpy as np
import numpy.typing as npt
import pytest
import torch

from singulate.agents.multimodal_ppo.config import MultimodalPPOConfig
from singulate.agents.multimodal_ppo.policy import build_policy
from singulate.envs import EnvConfig

CONFIG = MultimodalPPOConfig(net_arch=(8, 8))


@pytest.fixture
def observation() -> npt.NDArray[np.float32]:
    return np.random.default_rng(0).uniform(0, 40, (64, 64)).astype(np.float32)


def test_greedy_pushes_are_not_on_a_grid(observation: npt.NDArray[np.float32]) -> None:
    torch.manual_seed(0)
    policy = build_policy(CONFIG, EnvConfig("random-2"))
    for parameter in policy.network.parameters():
        torch.nn.init.normal_(parameter, std=0.4)
    offset = (policy.act(observation).start[0] + 1.0) * 8.0 % 1.0
    assert offset not in (0.0, 0.5)


def test_the_density_peaks_at_the_greedy_start_of_a_sure_policy(
    observation: npt.NDArray[np.float32],
) -> None:
    torch.manual_seed(1)
    policy = build_policy(CONFIG, EnvConfig("random-2"))
    torch.nn.init.normal_(policy.network.push_net.push_head.weight, std=30.0)
    density = policy.start_density(observation)
    assert density.max() > 0.05
    row, col = np.unravel_index(density.argmax(), density.shape)
    start_row, start_col = policy.workspace.xy_to_row_col(*policy.act(observation).start)
    assert abs(start_row - row) <= 2
    assert abs(start_col - col) <= 2
