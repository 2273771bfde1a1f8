"""The result of an evaluation."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from singulate.evaluation.evaluator import EpisodeResult
from singulate.evaluation.wilson import wilson_interval
from singulate.rewards import TERMS


@dataclass(frozen=True)
class Evaluation:
    """How a policy did.

    Attributes:
        num_episodes: Episodes played.
        num_successes: Episodes that ended with all blocks apart.
        success_interval: 95 % Wilson interval of the success rate.
        mean_reward: Mean sum of rewards of an episode.
        mean_reward_by_term: The same by term, weighted.
        failures: Number of failed episodes by what became of the last push.
        mean_pushes: Mean number of pushes of an episode.
    """

    num_episodes: int
    num_successes: int
    success_interval: tuple[float, float]
    mean_reward: float
    mean_reward_by_term: Mapping[str, float]
    failures: Mapping[str, int]
    mean_pushes: float

    @property
    def success_rate(self) -> float:
        """Share of successful episodes."""
        return self.num_successes / self.num_episodes

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "num_episodes": self.num_episodes,
            "num_successes": self.num_successes,
            "success_rate": self.success_rate,
            "success_interval_95": list(self.success_interval),
            "mean_reward": self.mean_reward,
            "mean_reward_by_term": dict(self.mean_reward_by_term),
            "failures": dict(self.failures),
            "mean_pushes": self.mean_pushes,
        }


def summarise(results: Sequence[EpisodeResult]) -> Evaluation:
    """Sum up at least one episode."""
    num_successes = sum(result.is_success for result in results)
    failures = Counter(result.outcome for result in results if not result.is_success)
    return Evaluation(
        num_episodes=len(results),
        num_successes=num_successes,
        success_interval=wilson_interval(num_successes, len(results)),
        mean_reward=float(np.mean([result.reward for result in results])),
        mean_reward_by_term={
            term: float(np.mean([result.terms[term] for result in results])) for term in TERMS
        },
        failures=dict(sorted(failures.items())),
        mean_pushes=float(np.mean([result.num_pushes for result in results])),
    )
