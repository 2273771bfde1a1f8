"""Trains an agent and looks now and then at how many unseen scenes it solves."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import torch
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.callbacks import BaseCallback

from singulate.evaluation.evaluator import EpisodeSpan, Evaluator, play_span
from singulate.training.config import TrainingConfig
from singulate.training.envs import make_training_envs
from singulate.training.model import build_training_model

FIRST_LOOK = 100
"""Pushes before the first look."""
LOOK_GROWTH = 1.2
"""Each look comes after this many times the pushes of the one before."""
NUM_SCENES = 500
EVALUATION_SEED = 12345
_SPAN = 25


class Look(NamedTuple):
    """What an agent could do at one moment of its training.

    Attributes:
        num_pushes: Pushes it had learned from.
        seconds: Time it had taken, without the looks [s].
        success: Share of the tried scenes that it solves.
        num_scenes: How many were tried: fewer than `NUM_SCENES` where the lowest of the wanted
            rates was soon out of reach, which then exceeds `success`.
    """

    num_pushes: int
    seconds: float
    success: float
    num_scenes: int


@dataclass(frozen=True)
class LearningCurve:
    """The looks of one training, in order, at least one."""

    looks: list[Look]

    def first(self, rate: float) -> Look | None:
        """The first look at which the agent solved this share; None where it never did."""
        return next((look for look in self.looks if look.success >= rate), None)

    @property
    def last(self) -> Look:
        """The look at the end of the training."""
        return self.looks[-1]


def learning_curve(config: TrainingConfig, rates: Sequence[float]) -> LearningCurve:
    """Train until the highest rate is reached or the training is over.

    The scenes are those of `evaluate` with `EVALUATION_SEED`; no training sees them.

    Args:
        config: What to train, and for how many pushes at most.
        rates: Wanted shares of solved scenes, ascending.
    """
    torch.set_num_threads(config.num_threads)
    torch.set_flush_denormal(True)
    envs = make_training_envs(config)
    try:
        model = build_training_model(config, envs)
        watch = _Watch(config, model, rates)
        model.learn(config.total_timesteps, callback=watch, log_interval=None)  # type: ignore[arg-type]
        return LearningCurve(watch.looks)
    finally:
        envs.close()


class _Watch(BaseCallback):
    """Stops the clock and evaluates a copy of the network."""

    def __init__(
        self, config: TrainingConfig, model: BaseAlgorithm, rates: Sequence[float]
    ) -> None:
        super().__init__()
        self.looks: list[Look] = []
        self._kind = config.kind
        self._model = model
        self._rates = rates
        self._last = config.total_timesteps
        policy, self._network = self._kind.build_policy(config.resolved_agent_config, config.env)
        self._scenes = Evaluator(policy, config.env)
        self._next_look = float(FIRST_LOOK)
        self._seconds, self._since = 0.0, time.perf_counter()

    def _on_training_start(self) -> None:
        self._since = time.perf_counter()

    def _on_step(self) -> bool:
        if self.num_timesteps < min(self._next_look, self._last):
            return True
        self._seconds += time.perf_counter() - self._since
        self._look()
        while self._next_look <= self.num_timesteps:
            self._next_look *= LOOK_GROWTH
        self._since = time.perf_counter()
        return self.looks[-1].success < self._rates[-1] and self.num_timesteps < self._last

    def _on_training_end(self) -> None:
        self._scenes.close()

    def _look(self) -> None:
        self._network.load_state_dict(self._kind.network_of(self._model).state_dict())
        most_failures = (1.0 - self._rates[0]) * NUM_SCENES
        num_tried, num_failed = 0, 0
        while num_tried < NUM_SCENES and num_failed <= most_failures:
            results = play_span(self._scenes, EpisodeSpan(EVALUATION_SEED, num_tried, _SPAN))
            num_tried += len(results)
            num_failed += sum(not result.is_success for result in results)
        success = 1.0 - num_failed / num_tried
        self.looks.append(Look(self.num_timesteps, self._seconds, success, num_tried))
