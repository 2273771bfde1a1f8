"""A trained spatial agent, ready to push."""

import numpy as np
import torch

from singulate.agents.observation import checked_observation
from singulate.agents.policy import FloatMap
from singulate.agents.reward_scale import REWARD_SCALE
from singulate.agents.spatial.choice import best_push
from singulate.agents.spatial.config import SpatialConfig
from singulate.agents.spatial.exploration import aimed_push
from singulate.agents.spatial.network import ValueNetwork
from singulate.agents.spatial.replay import as_distance_maps
from singulate.agents.spatial.turning import to_turned_pixels, turn_all_ways, turn_back
from singulate.agents.spatial.value_map import FOUR_VIEWS, value_maps
from singulate.agents.spatial.window import read_between
from singulate.envs import EnvConfig
from singulate.geometry import Push, Workspace


class SpatialPolicy:
    """Pushes where the network expects the highest reward, from a continuous start.

    Attributes:
        network: Values of pushes upwards for every pixel; see `ValueNetwork`.
    """

    kind = "spatial"
    is_random = False

    def __init__(self, config: SpatialConfig, env_config: EnvConfig, workspace: Workspace) -> None:
        self.observation = env_config.observation
        self.workspace = workspace
        self.network = ValueNetwork(*config.net_arch).eval()
        self._exploration_rate = config.exploration_final_eps

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The push of the highest value; with `rng`, now and then a random aimed one.

        In training, starts that are not explored are shaken as well (`start_noise`).
        """
        image = self._distance_map(observation)
        if rng is not None and rng.random() < self._exploration_rate:
            return aimed_push(image, self.workspace, rng)
        return best_push(self.network, image, self.workspace)

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Expected reward of the push from this very start, in the closest direction."""
        direction = push.nearest_direction
        start = np.array([push.start]) / self.workspace.half_length
        pixel = to_turned_pixels(start, np.array([int(direction)]), self.workspace.image_size)
        values = torch.from_numpy(self._turned_values(observation)[[direction]])
        inside = np.clip(pixel, 0, values.shape[1] - 1).astype(np.float32)
        return float(read_between(values, torch.from_numpy(inside)))

    def q_map(self, observation: FloatMap) -> FloatMap:
        """Expected reward of a push from every pixel of the image, float32 (4, H, W)."""
        return turn_back(self._turned_values(observation))

    def _turned_values(self, observation: FloatMap) -> FloatMap:
        turned = turn_all_ways(self._distance_map(observation))
        return value_maps(self.network, turned, FOUR_VIEWS) / np.float32(REWARD_SCALE)

    def _distance_map(self, observation: FloatMap) -> FloatMap:
        images = checked_observation(observation, self.workspace.image_size)[None]
        distance_map: FloatMap = as_distance_maps(images, self.observation)[0]
        return distance_map


def build_policy(
    config: SpatialConfig, env_config: EnvConfig, workspace: Workspace | None = None
) -> SpatialPolicy:
    """A policy with untrained weights, to be filled from a checkpoint."""
    return SpatialPolicy(config, env_config, workspace or Workspace())
