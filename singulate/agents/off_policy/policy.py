"""What a trained pair of critics tells of pushes."""

from collections.abc import Callable
from functools import cached_property

import numpy as np
import numpy.typing as npt

from singulate.agents.observation import batch_of_one
from singulate.agents.off_policy.networks import ActorAndCritics, Networks
from singulate.agents.off_policy.values import lower_values_of_one
from singulate.agents.policy import FloatMap
from singulate.agents.reward_scale import REWARD_SCALE
from singulate.envs import EnvConfig, make_action_encoding, make_observation
from singulate.geometry import Direction, Push, Workspace


class ActorCriticPolicy:
    """The common part of SAC's and TD3's policies.

    Args:
        networks_class: stable-baselines3's policy.
        arguments: Its arguments.
        env_config: The task; decides observation and action encoding.
        workspace: What can be reached.

    Attributes:
        network: Actor and critics.
    """

    def __init__(
        self,
        networks_class: Callable[..., Networks],
        arguments: dict[str, object],
        env_config: EnvConfig,
        workspace: Workspace | None = None,
    ) -> None:
        self.observation = env_config.observation
        self.workspace = workspace or Workspace()
        self._encoding = make_action_encoding(env_config.action, self.workspace)
        networks = networks_class(
            make_observation(env_config.observation, self.workspace).space,
            self._encoding.space,
            lambda _: 0.0,
            **arguments,
        )
        self.network = ActorAndCritics(networks).eval()

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Expected total reward of the action closest to `push`, by the lower critic."""
        return float(self._values(observation, self._encoding.encode(push)[None])[0])

    def q_map(self, observation: FloatMap) -> FloatMap:
        """The same of the cardinal pushes from every pixel, float32 (4, H, W)."""
        size = self.workspace.image_size
        return self._values(observation, self._cardinal_actions).reshape(len(Direction), size, size)

    @cached_property
    def _cardinal_actions(self) -> npt.NDArray[np.float32]:
        """float32 (4 * H * W, dims): up, right, down, left; row by row."""
        size, length = self.workspace.image_size, self.workspace.push_length
        pushes = [
            Push.cardinal(self.workspace.row_col_to_xy(row, col, size), direction, length)
            for direction in Direction
            for row in range(size)
            for col in range(size)
        ]
        return np.stack([self._encoding.encode(push) for push in pushes])

    def _values(self, observation: FloatMap, actions: npt.NDArray[np.float32]) -> FloatMap:
        picture = batch_of_one(observation, self.workspace.image_size)
        return lower_values_of_one(self.network.critic, picture, actions) / np.float32(REWARD_SCALE)
