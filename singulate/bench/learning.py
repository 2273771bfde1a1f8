"""Pushes per second of each agent while it learns, and where the time goes."""

import multiprocessing
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from typing import TYPE_CHECKING

from singulate.bench.measurement import BenchOptions, Measurement
from singulate.envs import EnvConfig
from singulate.training.config import TrainingConfig

if TYPE_CHECKING:
    from singulate.bench.learning_time import LearningTime

SECONDS_FACTOR = 4.0
"""A measurement takes this many times the usual seconds: PPO alternates pushes and updates."""

CONFIGS = (
    TrainingConfig("dqn", EnvConfig("random-2", action="grid"), 1_000_000),
    TrainingConfig("ppo", EnvConfig("fixed-2"), 1_000_000, agent_config={"n_steps": 256}),
)
"""Default settings, but PPO updates after 256 pushes to fit the time; a push costs the same."""


def bench_learning(options: BenchOptions) -> Iterator[Measurement]:
    """Train each agent shortly in a process of its own, without record and checkpoints."""
    from singulate.bench.learning_time import measure_learning

    for config in CONFIGS:
        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(1, mp_context=context) as pool:
            seconds = SECONDS_FACTOR * options.seconds
            spent = pool.submit(measure_learning, config, seconds).result()
        yield from _measurements(config, spent)


def _measurements(config: TrainingConfig, spent: "LearningTime") -> Iterator[Measurement]:
    agent = config.agent.upper()
    note = (
        f"{config.env.scenario}, {spent.num_pushes} pushes of a new agent once it updates, "
        "one thread, no record or checkpoints"
    )
    rate = spent.num_pushes / spent.total_s
    yield Measurement(f"{agent}, learning", rate, "pushes/s", note)
    acting_s = spent.total_s - spent.environment_s - spent.update_s
    parts = {
        "environment": (spent.environment_s, "reset and step"),
        "acting": (acting_s, "the rest: choosing and storing pushes"),
        "update": (spent.update_s, "training the networks"),
    }
    for part, (seconds, what) in parts.items():
        share = f"{seconds / spent.total_s:.0%} of the time; {what}"
        yield Measurement(f"{agent}, {part}", 1e3 * seconds / spent.num_pushes, "ms/push", share)
    memory = spent.peak_bytes / 2**20
    yield Measurement(
        f"{agent}, peak memory", memory, "MiB", "resident; a replay buffer fills up later"
    )
