"""Trains for a while with a stopwatch."""

import time
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from stable_baselines3.common.callbacks import BaseCallback

from singulate.bench.memory import own_memory
from singulate.envs import PushEnv
from singulate.training.config import TrainingConfig
from singulate.training.model import build_training_model
from singulate.training.seeded_episodes import SeededEpisodes


@dataclass(frozen=True)
class LearningTime:
    """What a training took.

    Attributes:
        num_pushes: Pushes that were timed.
        total_s: Time for them [s].
        environment_s: Part of it in the environment [s].
        update_s: Part of it in updates of the networks [s].
        peak_bytes: Largest resident memory of the process [bytes].
    """

    num_pushes: int
    total_s: float
    environment_s: float
    update_s: float
    peak_bytes: int


def measure_learning(config: TrainingConfig, seconds: float) -> LearningTime:
    """Train a new agent and time whole rollouts with their updates.

    Args:
        config: What to train; `total_timesteps` is beyond reach.
        seconds: The first rollout that begins this long after the first update ends it [s].
    """
    torch.set_num_threads(config.num_threads)
    torch.set_flush_denormal(True)
    env = PushEnv(None, **config.env.to_dict())
    episodes = _TimedEpisodes(env, config.seed)
    model = build_training_model(config, episodes)
    watch = _Stopwatch(episodes, int(getattr(model, "learning_starts", 0)), seconds)
    try:
        model.learn(config.total_timesteps, callback=watch)
    except _TimeIsUp:
        pass
    finally:
        env.close()
    return LearningTime(
        num_pushes=model.num_timesteps - watch.first_push,
        total_s=watch.total_s,
        environment_s=episodes.spent_s,
        update_s=watch.update_s,
        peak_bytes=own_memory().peak_bytes,
    )


class _TimedEpisodes(SeededEpisodes):
    """Adds up the time [s] in the environment."""

    spent_s = 0.0

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        began = time.perf_counter()
        result = super().reset(seed=seed, options=options)
        self.spent_s += time.perf_counter() - began
        return result

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        began = time.perf_counter()
        result = super().step(action)
        self.spent_s += time.perf_counter() - began
        return result


class _TimeIsUp(Exception):  # noqa: N818 - no error: leaves stable-baselines3's loop
    """Raised between two rollouts."""


class _Stopwatch(BaseCallback):
    """Times updates, which stable-baselines3 makes between two rollouts.

    Args:
        episodes: Where the time in the environment is added up.
        learning_starts: Pushes before the first update; they are not timed.
        seconds: Time after which no further rollout begins [s].
    """

    def __init__(self, episodes: _TimedEpisodes, learning_starts: int, seconds: float) -> None:
        super().__init__()
        self.first_push = 0
        self.total_s = 0.0
        self.update_s = 0.0
        self._episodes = episodes
        self._learning_starts = learning_starts
        self._seconds = seconds
        self._began: float | None = None
        self._rollout_ended = 0.0

    def _on_rollout_start(self) -> None:
        now = time.perf_counter()
        if self._began is not None:
            self.update_s += now - self._rollout_ended
            self.total_s = now - self._began
            if self.total_s >= self._seconds:
                raise _TimeIsUp
        elif self.num_timesteps >= self._learning_starts:
            self._began, self.first_push = now, self.num_timesteps
            self._episodes.spent_s = 0.0

    def _on_rollout_end(self) -> None:
        self._rollout_ended = time.perf_counter()

    def _on_step(self) -> bool:
        return True
