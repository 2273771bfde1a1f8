"""Pushes and seconds until each agent solves 95 % and 99 % of scenes that it has not seen."""

import math
import multiprocessing
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from statistics import median

from singulate.agents.registry import agent_kind
from singulate.bench.learning_curve import NUM_SCENES, LearningCurve, learning_curve
from singulate.bench.measurement import BenchOptions, Measurement
from singulate.envs import EnvConfig
from singulate.training.config import TrainingConfig

RATES = (0.95, 0.99)
SCENARIO = "random-2"
PAPERS_AGENT = "dqn"
"""The agent of the paper that learns random scenes (section 5.4)."""
MAX_PUSHES = {
    "spatial": 3_000,
    "multimodal-ppo": 24_000,
    "dqn": 20_000,
    "ppo": 20_000,
}
"""Agents in the order of the table, and when each is given up."""


def bench_learning(options: BenchOptions) -> Iterator[Measurement]:
    """Train each agent with its default settings, seed after seed, each in a fresh process."""
    seeds = range(options.num_seeds)
    curves = {agent: [_curve(agent, seed) for seed in seeds] for agent in MAX_PUSHES}
    for agent, its_curves in curves.items():
        for rate in RATES:
            yield from _times(agent, rate, its_curves)
        yield _success(agent, its_curves)
    for agent in curves:
        if agent != PAPERS_AGENT:
            for rate in RATES:
                yield _gain(agent, rate, curves[agent], curves[PAPERS_AGENT])


def _curve(agent: str, seed: int) -> LearningCurve:
    env = EnvConfig(SCENARIO, action=agent_kind(agent).actions[0])
    config = TrainingConfig(agent, env, MAX_PUSHES[agent], seed)
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        return pool.submit(learning_curve, config, RATES).result()


def _times(agent: str, rate: float, curves: Sequence[LearningCurve]) -> Iterator[Measurement]:
    looks = [look for curve in curves if (look := curve.first(rate)) is not None]
    for what, unit, values in (
        ("pushes", "", [look.num_pushes for look in looks]),
        ("seconds", "s", [look.seconds for look in looks]),
    ):
        note = f"median of {len(curves)} seeds"
        if len(values) < len(curves):
            note += f", of which {len(values)} get there in {MAX_PUSHES[agent]} pushes"
        if values:
            note += f"; {min(values):.4g} to {max(values):.4g}"
        middle = _median_or_none(values, len(curves))
        yield Measurement(f"{agent}, {what} to {rate:.0%}", middle, unit, note)


def _success(agent: str, curves: Sequence[LearningCurve]) -> Measurement:
    shares = [curve.looks[-1].success for curve in curves]
    last = max(curve.looks[-1].num_pushes for curve in curves)
    note = (
        f"at the last look, after at most {last} pushes; {min(shares):.1%} to {max(shares):.1%}, "
        f"of at most {NUM_SCENES} scenes"
    )
    return Measurement(f"{agent}, success", median(shares), "", note)


def _gain(
    agent: str, rate: float, curves: Sequence[LearningCurve], papers: Sequence[LearningCurve]
) -> Measurement:
    """Pushes that the paper's agent needs for each push of this one, by medians."""
    name = f"{agent}, pushes to {rate:.0%}, gain"
    ours, theirs = _median_pushes(curves, rate), _median_pushes(papers, rate)
    if ours is None:
        return Measurement(name, None, "", f"{agent} does not get there")
    if theirs is None:
        most = MAX_PUSHES[PAPERS_AGENT]
        note = f"at least: {PAPERS_AGENT} does not get there in {most} pushes"
        return Measurement(name, most / ours, "", note)
    return Measurement(name, theirs / ours, "", f"to {PAPERS_AGENT}")


def _median_pushes(curves: Sequence[LearningCurve], rate: float) -> float | None:
    looks = [look for curve in curves if (look := curve.first(rate)) is not None]
    return _median_or_none([look.num_pushes for look in looks], len(curves))


def _median_or_none(values: Sequence[float], num_seeds: int) -> float | None:
    """The median where seeds that do not arrive come after all that do; None if it is of those."""
    middle = median([*values, *[math.inf] * (num_seeds - len(values))])
    return middle if math.isfinite(middle) else None
