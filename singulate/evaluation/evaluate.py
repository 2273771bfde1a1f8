"""Evaluates a policy, in worker processes where there are several cores."""

import functools
from collections.abc import Callable, Iterator

from singulate.agents.config_fields import check_int
from singulate.agents.policy import Policy
from singulate.engine import LocalEngine
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
    workers: int = 1,
    on_progress: Callable[[int], None] | None = None,
) -> Evaluation:
    """Play episodes on scenes that no training sees, the same for all policies.

    The result does not depend on the number of workers.

    Args:
        policy: What to evaluate.
        env_config: The task.
        episodes: Number of episodes.
        seed: Seed of the evaluation.
        sample: Whether the policy draws pushes as in training (True) or is greedy (False); by
            default as it is meant to act.
        workers: Processes; with 1, everything happens in this one.
        on_progress: Called with the number of finished episodes now and then.

    Raises:
        InvalidValueError: If `episodes`, `seed` or `workers` is out of range.
        EngineError: If a worker failed twice.
    """
    check_int("episodes", episodes, 1, 10_000_000)
    check_int("seed", seed, 0, 2**63 - 1)
    check_int("workers", workers, 1, 256)
    spans = [
        EpisodeSpan(seed, first, min(SPAN, episodes - first)) for first in range(0, episodes, SPAN)
    ]
    results: list[EpisodeResult] = []
    for part in _play(functools.partial(Evaluator, policy, env_config, sample), spans, workers):
        results += part
        if on_progress is not None:
            on_progress(len(results))
    return summarise(sorted(results, key=lambda result: result.index))


def _play(
    make_evaluator: Callable[[], Evaluator], spans: list[EpisodeSpan], workers: int
) -> Iterator[list[EpisodeResult]]:
    if workers == 1:
        evaluator = make_evaluator()
        try:
            for span in spans:
                yield play_span(evaluator, span)
        finally:
            evaluator.close()
        return
    with LocalEngine(min(workers, len(spans)), niceness=5) as engine:
        for result in engine.submit(play_span, spans, make_evaluator):
            yield result.value
