"""Evaluates a policy, in the workers of an engine or in this process."""

import functools
from collections.abc import Callable, Iterator

from singulate.agents.config_fields import check_int
from singulate.agents.policy import Policy
from singulate.engine import Engine
from singulate.envs import EnvConfig
from singulate.evaluation.evaluation import Evaluation, summarise
from singulate.evaluation.evaluator import EpisodeResult, EpisodeSpan, Evaluator, play_span

SPAN = 20
"""Episodes of one task: some seconds of work."""


def evaluate(
    policy: Policy,
    env_config: EnvConfig,
    episodes: int,
    seed: int = 0,
    *,
    sample: bool | None = None,
    engine: Engine | None = None,
    on_progress: Callable[[int], None] | None = None,
) -> Evaluation:
    """Play episodes on scenes that no training sees, the same for all policies.

    The result does not depend on the engine.

    Args:
        policy: What to evaluate.
        env_config: The task.
        episodes: Number of episodes.
        seed: Seed of the evaluation.
        sample: Whether the policy draws pushes (True) or is greedy (False); by
            default as it is meant to act.
        engine: Where episodes are played; None for this process.
        on_progress: Called with the number of finished episodes now and then.

    Raises:
        InvalidValueError: If `episodes` or `seed` is out of range.
        EngineError: If a worker failed twice.
    """
    check_int("episodes", episodes, 1, 10_000_000)
    check_int("seed", seed, 0, 2**63 - 1)
    spans = [
        EpisodeSpan(seed, first, min(SPAN, episodes - first)) for first in range(0, episodes, SPAN)
    ]
    results: list[EpisodeResult] = []
    for part in _play(functools.partial(Evaluator, policy, env_config, sample), spans, engine):
        results += part
        if on_progress is not None:
            on_progress(len(results))
    return summarise(sorted(results, key=lambda result: result.index))


def _play(
    make_evaluator: Callable[[], Evaluator], spans: list[EpisodeSpan], engine: Engine | None
) -> Iterator[list[EpisodeResult]]:
    if engine is not None:
        for result in engine.submit(play_span, spans, make_evaluator):
            yield result.value
        return
    evaluator = make_evaluator()
    try:
        for span in spans:
            yield play_span(evaluator, span)
    finally:
        evaluator.close()
