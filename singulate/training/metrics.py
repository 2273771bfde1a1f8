"""Training curves from single pushes."""

import math
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.on_policy_algorithm import OnPolicyAlgorithm

SMOOTHING_EPISODES = 1000
_ENTROPY_OF_UNIT_NORMAL = 0.5 * math.log(2.0 * math.pi * math.e)


@dataclass(frozen=True)
class Episode:
    """One finished episode: sum of rewards, pushes, and whether it ended in success."""

    total_reward: float
    num_pushes: int
    is_success: bool


class EpisodeMetrics:
    """Collects episodes; names follow stable-baselines3 where it has one.

    Args:
        num_envs: Environments, each with an episode of its own under way.
    """

    def __init__(self, num_envs: int = 1) -> None:
        self._recent: list[Episode] = []
        self._smooth: deque[Episode] = deque()
        self._sums = [0.0, 0]
        self._terms: list[Mapping[str, float]] = []
        self._rewards = [0.0] * num_envs
        self._num_pushes = [0] * num_envs

    @property
    def num_episodes(self) -> int:
        """Episodes that `success_rate` and `mean_reward` are about."""
        return len(self._smooth)

    @property
    def success_rate(self) -> float:
        """Share of successes among the last `SMOOTHING_EPISODES` episodes, 0 before the first."""
        return self._sums[1] / max(len(self._smooth), 1)

    @property
    def mean_reward(self) -> float:
        """Mean episode reward over the same episodes."""
        return self._sums[0] / max(len(self._smooth), 1)

    def add_push(
        self,
        reward: float,
        terms: Mapping[str, float],
        is_success: bool,
        is_done: bool,
        env_index: int = 0,
    ) -> None:
        """Count a push.

        Args:
            reward: Its reward.
            terms: Its unweighted reward terms by name.
            is_success: Whether the scene was singulated afterwards.
            is_done: Whether it was the last of its episode.
            env_index: Environment that pushed.
        """
        self._rewards[env_index] += reward
        self._num_pushes[env_index] += 1
        self._terms.append(terms)
        if is_done:
            total, num_pushes = self._rewards[env_index], self._num_pushes[env_index]
            self._add_episode(Episode(total, num_pushes, is_success))
            self._rewards[env_index], self._num_pushes[env_index] = 0.0, 0

    def _add_episode(self, episode: Episode) -> None:
        self._recent.append(episode)
        self._smooth.append(episode)
        self._sums[0] += episode.total_reward
        self._sums[1] += episode.is_success
        if len(self._smooth) > SMOOTHING_EPISODES:
            oldest = self._smooth.popleft()
            self._sums[0] -= oldest.total_reward
            self._sums[1] -= oldest.is_success

    def collect(self) -> dict[str, float]:
        """Metrics since the last call, by name; empty where no episode has ended."""
        recent, self._recent = self._recent, []
        terms, self._terms = self._terms, []
        if not recent:
            return {}
        values = {
            "rollout/ep_rew_mean": _mean([episode.total_reward for episode in recent]),
            "rollout/ep_rew_mean_smooth": self.mean_reward,
            "rollout/success_rate": _mean([episode.is_success for episode in recent]),
            "rollout/success_rate_smooth": self.success_rate,
            "rollout/ep_len_mean": _mean([episode.num_pushes for episode in recent]),
        }
        for name in terms[0]:
            values[f"reward_terms/{name}"] = _mean([push[name] for push in terms])
        return values


def model_metrics(model: BaseAlgorithm) -> dict[str, float]:
    """What the model's last update and exploration logged, by name.

    Args:
        model: A model whose logger is never dumped, so that the last values stay there.
    """
    logged: Mapping[str, Any] = model.logger.name_to_value
    values = {
        name: float(value)
        for name, value in logged.items()
        if name.startswith(("train/", "rollout/")) and isinstance(value, int | float | np.number)
    }
    if "train/entropy_loss" in values:
        values["train/entropy"] = -values["train/entropy_loss"]
    if isinstance(model, OnPolicyAlgorithm) and hasattr(model.policy, "log_std"):
        log_std = model.policy.log_std.detach()
        values["train/std"] = float(log_std.exp().mean())
        entropy = float((log_std + _ENTROPY_OF_UNIT_NORMAL).sum())
        values.setdefault("train/entropy", entropy)
    return values


def _mean(values: list[bool] | list[float] | list[int]) -> float:
    return float(np.mean(values)) if values else 0.0
