"""A trained Gaussian agent, ready to push."""

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.common.policies import ActorCriticPolicy

from singulate.agents.gaussian.density import gaussian_start_density
from singulate.agents.gaussian.networks import GaussianSettings, network_arguments
from singulate.agents.observation import batch_of_one
from singulate.agents.policy import FloatMap
from singulate.agents.reward_scale import REWARD_SCALE
from singulate.envs import EnvConfig, make_action_encoding, make_observation
from singulate.geometry import Push, Workspace

FloatVector = npt.NDArray[np.float64]


class GaussianPolicy:
    """Draws pushes from a Gaussian that a network places for each observation.

    Training rewards the distribution, not its mean: on two equal blocks the mean ends up on the
    axis of symmetry, where a push meets both blocks at once, while most drawn pushes succeed.

    Args:
        kind: Name in the agent registry.
        config: The agent's settings.
        env_config: The task; decides observation and action encoding.
        workspace: What can be reached.

    Attributes:
        network: Actor and critic of stable-baselines3.
    """

    is_random = True

    def __init__(
        self,
        kind: str,
        config: GaussianSettings,
        env_config: EnvConfig,
        workspace: Workspace | None = None,
    ) -> None:
        workspace = workspace or Workspace()
        self.kind = kind
        self.observation = env_config.observation
        self.workspace = workspace
        self._encoding = make_action_encoding(env_config.action, workspace)
        self.network = ActorCriticPolicy(
            make_observation(env_config.observation, workspace).space,
            self._encoding.space,
            lambda _: config.learning_rate,
            **network_arguments(config, env_config.observation),  # type: ignore[arg-type]
        ).eval()

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """The mean push; with `rng`, one drawn from the Gaussian, as in training."""
        mean, deviation = self.action_distribution(observation)
        action = mean if rng is None else rng.normal(mean, deviation)
        return self._encoding.decode(np.clip(action, -1.0, 1.0).astype(np.float32))

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Expected total reward of pushing as the policy would; the same for every `push`."""
        picture = batch_of_one(observation, self.workspace.image_size)
        with torch.no_grad():
            value = self.network.predict_values(picture)
        return float(value[0, 0]) / REWARD_SCALE

    def start_density(self, observation: FloatMap) -> FloatMap:
        """Probability that a push starts in each image cell, float32 (H, W), summing to 1."""
        mean, deviation = self.action_distribution(observation)
        return gaussian_start_density(mean[:2], deviation[:2], self.workspace.image_size)

    def action_distribution(self, observation: FloatMap) -> tuple[FloatVector, FloatVector]:
        """Mean and standard deviation of the action before clipping, float64 (dims,) each."""
        picture = batch_of_one(observation, self.workspace.image_size)
        with torch.no_grad():
            mean = self.network.get_distribution(picture).mode()[0].numpy()
            deviation = self.network.log_std.exp().numpy()
        return mean.astype(np.float64), deviation.astype(np.float64)
