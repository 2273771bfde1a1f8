"""A trained DQN, ready to push."""

import math

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.dqn.policies import DQNPolicy

from singulate.agents.dqn.config import DQNConfig
from singulate.agents.dqn.model import network_arguments
from singulate.agents.dqn.symmetry import mean_of_copies, symmetric_copies
from singulate.agents.observation import checked_observation
from singulate.agents.policy import FloatMap
from singulate.agents.reward_scale import REWARD_SCALE
from singulate.envs import EnvConfig, GridActions, make_observation
from singulate.geometry import Push, Workspace


class GridPolicy:
    """Pushes where the Q network expects the highest reward.

    Attributes:
        network: The Q network; (batch, H, W) to (batch, 4 * cells ** 2).
    """

    kind = "dqn"
    is_random = False

    def __init__(self, config: DQNConfig, env_config: EnvConfig, workspace: Workspace) -> None:
        self.observation = env_config.observation
        self.workspace = workspace
        self._encoding = GridActions(workspace)
        self._exploration_rate = config.exploration_final_eps
        self._is_symmetric = config.symmetric_values
        policy = DQNPolicy(
            make_observation(env_config.observation, workspace).space,
            self._encoding.space,
            lambda _: config.learning_rate,
            **network_arguments(config, env_config.observation),  # type: ignore[arg-type]
        )
        self.network: torch.nn.Module = policy.q_net.eval()

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The push of the highest value; with `rng`, now and then a uniformly random one."""
        if rng is not None and rng.random() < self._exploration_rate:
            return self._encoding.decode(int(rng.integers(self._encoding.space.n)))
        return self._encoding.decode(int(self._values(observation).argmax()))

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Expected total reward of the discrete push closest to `push`."""
        values = self.q_map(observation)
        row, col = self.workspace.xy_to_row_col(*push.start, resolution=values.shape[-1])
        return float(values[push.nearest_direction, row, col])

    def q_map(self, observation: FloatMap) -> FloatMap:
        """Expected total reward of every discrete push, float32 (4, cells, cells)."""
        values = self._values(observation) / REWARD_SCALE
        cells = math.isqrt(values.size // 4)
        return values.reshape(4, cells, cells).astype(np.float32)

    def _values(self, observation: FloatMap) -> npt.NDArray[np.float32]:
        images = checked_observation(observation, self.workspace.image_size)[None]
        if self._is_symmetric:
            images = symmetric_copies(images)
        with torch.no_grad():
            values: npt.NDArray[np.float32] = self.network(torch.as_tensor(images)).numpy()
        return mean_of_copies(values) if self._is_symmetric else values[0]


def build_policy(
    config: DQNConfig, env_config: EnvConfig, workspace: Workspace | None = None
) -> GridPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return GridPolicy(config, env_config, workspace or Workspace())
