"""The spatial agent in training: single pushes, a memory of them, and their rewards as targets."""

from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from gymnasium import spaces
from stable_baselines3.common.noise import ActionNoise
from stable_baselines3.common.vec_env import VecEnv

from singulate.agents.annealing import annealed, set_learning_rate
from singulate.agents.overlap import OverlappedSteps, OverlappedUpdates
from singulate.agents.policy import FloatMap
from singulate.agents.spatial.choice import best_push
from singulate.agents.spatial.config import SpatialConfig
from singulate.agents.spatial.exploration import aimed_push
from singulate.agents.spatial.networks import SpatialNetworks
from singulate.agents.spatial.replay import PushMemory, as_distance_maps, directions_of
from singulate.agents.spatial.turning import to_turned_pixels, turn_each
from singulate.agents.spatial.update import gradient_step
from singulate.agents.spatial.value_map import ONE_VIEW
from singulate.agents.spatial.window import cut_windows, read_between
from singulate.envs import PointActions
from singulate.geometry import Push, Workspace


class SpatialModel(OverlappedUpdates):
    """Learns what single pushes are worth, inside stable-baselines3's loop.

    The value of a push is its own reward: no discount, no target network. In episodes of several
    pushes each is judged for itself. With several environments an update happens while they push,
    as for the DQN.

    Args:
        settings: The agent's settings.
        observation: Name of the observation.

    Attributes:
        exploration_rate: Share of pushes that are random, aimed at objects.
        predicted_values: Expected (scaled) reward of the pushes chosen last, float32 (num_envs,).
    """

    policy: SpatialNetworks
    replay_buffer: PushMemory

    def __init__(
        self, env: VecEnv, settings: SpatialConfig, observation: str, **kwargs: Any
    ) -> None:
        super().__init__(
            SpatialNetworks,
            env,
            learning_rate=settings.learning_rate,
            support_multi_env=True,
            sde_support=False,
            supported_action_spaces=(spaces.Box,),
            policy_kwargs={"net_arch": settings.net_arch, "observation": observation},
            **kwargs,
        )
        self.settings = settings
        self.exploration_rate = 1.0
        self.exploration_rng = np.random.default_rng(self.seed)
        self.predicted_values: npt.NDArray[np.float32] = np.zeros(self.n_envs, np.float32)
        self._observation = observation
        self._workspace = Workspace()
        self._encoding = PointActions(self._workspace)
        self._setup_model()

    @property
    def generators(self) -> dict[str, np.random.Generator]:
        """Every generator of its own that training draws from, by name."""
        return {"exploration": self.exploration_rng, "replay": self.replay_buffer.rng}

    def update(self, gradient_steps: int) -> None:
        """Improve the network by so many gradient steps."""
        self.policy.set_training_mode(True)
        rate = learning_rate_at(self.num_timesteps, self.settings)
        set_learning_rate(self, self.policy.optimizer, rate)
        losses = []
        for _ in range(gradient_steps):
            batch = self.replay_buffer.sample_pushes(self.batch_size)
            losses.append(gradient_step(self.policy, batch, self.settings))
        self._n_updates += gradient_steps
        self.logger.record("train/n_updates", self._n_updates, exclude="tensorboard")
        self.logger.record("train/loss", np.mean(losses))

    def _on_step(self) -> None:
        self.exploration_rate = annealed(
            1.0,
            self.settings.exploration_final_eps,
            self.num_timesteps,
            self.settings.exploration_steps,
        )
        self.logger.record("rollout/exploration_rate", self.exploration_rate)

    def _sample_action(
        self, learning_starts: int, action_noise: ActionNoise | None = None, n_envs: int = 1
    ) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float32]]:
        assert isinstance(self._last_obs, np.ndarray)
        maps = as_distance_maps(self._last_obs, self._observation)
        rate = 1.0 if self.num_timesteps < learning_starts else self.exploration_rate
        is_explored = self.exploration_rng.random(n_envs) < rate
        pushes = [self._choose(*pair) for pair in zip(maps, is_explored, strict=True)]
        actions = np.stack([self._encoding.encode(push) for push in pushes])
        self.predicted_values = self._values_of(maps, actions)
        return actions, actions

    def _choose(self, distance_map: FloatMap, is_explored: bool) -> Push:
        if is_explored:
            return aimed_push(distance_map, self._workspace, self.exploration_rng)
        push = best_push(self.policy.average, distance_map, self._workspace, ONE_VIEW)
        half = self._workspace.half_length
        noise = self.exploration_rng.normal(0.0, self.settings.start_noise, size=2)
        x, y = np.clip(np.array(push.start) + noise, -half, half)
        return Push((float(x), float(y)), push.direction, push.length)

    def _values_of(
        self, maps: FloatMap, actions: npt.NDArray[np.float32]
    ) -> npt.NDArray[np.float32]:
        exact = actions.astype(np.float64)
        directions = directions_of(exact)
        turned = turn_each(maps, directions)
        pixels = to_turned_pixels(exact[:, :2], directions, maps.shape[1])
        windows = cut_windows(turned, pixels, rng=None)
        with torch.no_grad():
            cells = self.policy.average(torch.from_numpy(windows.canvases))
            values = read_between(cells, torch.from_numpy(windows.pixels))
        found: npt.NDArray[np.float32] = values.numpy()
        return found


def learning_rate_at(num_pushes: int, config: SpatialConfig) -> float:
    """Adam's step size after so many pushes; see `SpatialConfig.learning_rate_decay`."""
    fall: float = (1.0 + num_pushes / config.learning_rate_decay) ** -0.5
    return config.learning_rate * fall


def build_model(config: SpatialConfig, env: VecEnv, observation: str, seed: int) -> SpatialModel:
    """Build an untrained model.

    Args:
        config: Its settings.
        env: Environments with ``point`` actions.
        observation: Name of its observation.
        seed: Seeds the network and all random choices.
    """
    steps = OverlappedSteps(env) if env.num_envs > 1 else env
    memory = {"seed": seed, "best_share": config.best_share, "observation": observation}
    model = SpatialModel(
        steps,
        config,
        observation,
        buffer_size=config.buffer_size,
        learning_starts=config.learning_starts,
        batch_size=config.batch_size,
        train_freq=1,
        gradient_steps=config.gradient_steps * env.num_envs,
        replay_buffer_class=PushMemory,
        replay_buffer_kwargs=memory,
        seed=seed,
        device="cpu",
    )
    if isinstance(steps, OverlappedSteps):
        steps.meanwhile = model.update_meanwhile
    return model


def network_of(model: SpatialModel) -> torch.nn.Module:
    """The part of a model that acting needs: the running average of its weights."""
    return model.policy.average
