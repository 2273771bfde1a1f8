"""Plays single evaluation episodes."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from singulate.agents.policy import Policy, SeesPoses
from singulate.envs import EnvConfig, PushEnv, make_observation, scene_seed
from singulate.envs.outcome_kind import outcome_kind
from singulate.exceptions import SimulationError
from singulate.geometry import Push
from singulate.outcomes import SIMULATION_ERROR
from singulate.rewards import TERMS, make_reward


class EpisodeSpan(NamedTuple):
    """Consecutive episodes of one evaluation."""

    seed: int
    first: int
    length: int


@dataclass(frozen=True)
class EpisodeResult:
    """One episode.

    Attributes:
        index: Its number in the evaluation.
        reward: Sum of rewards.
        terms: Weighted share of each reward term in it, by name.
        num_pushes: Pushes made.
        is_success: Whether it ended with all blocks apart.
        outcome: What became of its last push: one of `OUTCOMES`.
    """

    index: int
    reward: float
    terms: dict[str, float]
    num_pushes: int
    is_success: bool
    outcome: str


class Evaluator:
    """A policy and a table to try it on.

    Args:
        policy: What to try.
        env_config: The task; the policy chooses pushes, so its ``action`` has no effect, and the
            policy's own observation is used.
        sample: Whether the policy draws pushes (True) or is greedy (False); by
            default as it is meant to act.
    """

    def __init__(self, policy: Policy, env_config: EnvConfig, sample: bool | None = None) -> None:
        self._policy = policy
        self._needs_rng = policy.is_random if sample is None else sample
        self._env = PushEnv(None, **env_config.to_dict())
        self._observation = make_observation(policy.observation, self._env.task.workspace)
        self._reward = make_reward(env_config.reward)

    def play(self, seed: int, index: int) -> EpisodeResult:
        """Play one episode; its scene depends on the seed and the number alone.

        The reward's weights are those after all warm-up pushes.
        """
        scene = scene_seed("evaluation", seed, index)
        self._env.reset(seed=scene)
        rng = np.random.default_rng([scene, 1]) if self._needs_rng else None
        total, terms = 0.0, dict.fromkeys(TERMS, 0.0)
        num_pushes, is_success, is_over, kind = 0, False, False, SIMULATION_ERROR
        while not is_over and num_pushes < self._env.config.push_limit:
            num_pushes += 1
            push = self._choose(rng)
            try:
                result = self._env.task.execute(push)
            except SimulationError:
                kind = SIMULATION_ERROR
                break
            weighted = self._reward.weighted(result.terms, self._reward.num_warmup_pushes)
            terms = {name: terms[name] + value for name, value in weighted.items()}
            total += sum(weighted.values())
            is_success = result.is_success
            kind = outcome_kind(result.outcome, is_success)
            is_over = is_success or bool(result.outcome.fallen)
        return EpisodeResult(index, total, terms, num_pushes, is_success, kind)

    def close(self) -> None:
        """Release the physics engine."""
        self._env.close()
        if isinstance(self._policy, SeesPoses):
            self._policy.close()

    def _choose(self, rng: np.random.Generator | None) -> Push:
        task = self._env.task
        if isinstance(self._policy, SeesPoses):
            return self._policy.act_on(task.scene.poses, task.goal_separation)
        return self._policy.act(self._observation.observe(task.percept), rng)


def play_span(evaluator: Evaluator, span: EpisodeSpan) -> list[EpisodeResult]:
    """Play consecutive episodes; the task of a worker process."""
    return [evaluator.play(span.seed, span.first + i) for i in range(span.length)]
