"""Pushes per second of each agent while it learns, and where the time goes."""

import multiprocessing
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from singulate.bench.measurement import BenchOptions, Measurement
from singulate.envs import EnvConfig
from singulate.training.config import TrainingConfig

if TYPE_CHECKING:
    from singulate.bench.training_time import TimedTraining, TrainingTime

SECONDS_FACTOR = 2.0
"""A measurement takes this many times the usual seconds: PPO alternates pushes and updates."""

CONFIGS = (
    TrainingConfig("dqn", EnvConfig("random-2", action="grid"), 1_000_000),
    TrainingConfig("ppo", EnvConfig("fixed-2"), 1_000_000, agent_config={"n_steps": 256}),
)
"""Default settings, but PPO updates after 256 pushes to fit the time; a push costs the same."""

NUM_ENVS = 4
WAYS = ((1, 0, 1), (NUM_ENVS, 1, 1), (NUM_ENVS, 2, 1), (NUM_ENVS, 2, 2))
"""Environments, workers and threads of torch that are compared; without workers the environments
are in the trainer."""


def bench_training(options: BenchOptions) -> Iterator[Measurement]:
    """Train each agent shortly without record and checkpoints, in ways that take turns."""
    for config in CONFIGS:
        trainings = [
            _Training(replace(config, num_envs=envs, num_workers=workers, num_threads=threads))
            for envs, workers, threads in WAYS
        ]
        with ExitStack() as stack:
            for training in trainings:
                stack.callback(training.close)
                training.begin()
            for _ in range(options.num_repeats):
                for training in trainings:
                    training.run(SECONDS_FACTOR * options.seconds / options.num_repeats)
            if config.agent == "dqn":
                yield from trainings[0].gradient_steps(options.seconds)
        first = trainings[0]
        for training in trainings:
            yield from training.measurements()
            if training is not first:
                yield Measurement(
                    f"{training.name}, gain", training.rate / first.rate, "", f"to {first.name}"
                )


class _Training:
    """A training in a process of its own, and the sum of what was measured of it."""

    def __init__(self, config: TrainingConfig) -> None:
        self._config = config
        self._turns: list[TrainingTime] = []
        context = multiprocessing.get_context("spawn")
        self._pool = ProcessPoolExecutor(1, context, _begin, (config,))

    @property
    def name(self) -> str:
        """What the tables call it."""
        config = self._config
        parts = [config.agent.upper(), _count(config.num_envs, "environment")]
        if config.resolved_num_workers:
            parts.append(_count(config.resolved_num_workers, "worker"))
        if config.num_threads > 1:
            parts.append(_count(config.num_threads, "thread"))
        return ", ".join(parts)

    @property
    def rate(self) -> float:
        """Pushes per second."""
        return self._sum("num_pushes") / self._sum("total_s")

    def begin(self) -> None:
        """Wait until it learns."""
        self._pool.submit(_warm_up).result()

    def run(self, seconds: float) -> None:
        """Let it learn for a while; see `TimedTraining.run`."""
        self._turns.append(self._pool.submit(_run, seconds).result())

    def gradient_steps(self, seconds: float) -> Iterator[Measurement]:
        """Our gradient step of a DQN against the same one in stable-baselines3."""
        ours, theirs = self._pool.submit(_time_gradient_steps, seconds).result()
        name = f"{self._config.agent.upper()}, gradient step"
        yield Measurement(name, 1e3 * ours, "ms", "of one-push episodes, one thread")
        yield Measurement(f"{name}, stable-baselines3", 1e3 * theirs, "ms", "the same bits, slower")
        yield Measurement(f"{name}, gain", theirs / ours, "", "in turns")

    def close(self) -> None:
        """End the process; its workers end with it."""
        self._pool.shutdown()

    def measurements(self) -> Iterator[Measurement]:
        """Its speed, where its time goes, and what it takes."""
        num_pushes, total_s = self._sum("num_pushes"), self._sum("total_s")
        note = (
            f"{self._config.env.scenario}, {num_pushes:.0f} pushes of a new agent once it updates, "
            f"{_count(self._config.num_threads, 'thread')} of torch, no record or checkpoints"
        )
        yield Measurement(self.name, self.rate, "pushes/s", note)
        for part in _parts(self._turns, is_local=not self._config.resolved_num_workers):
            share = f"{part.seconds / total_s:.0%} of the time; {part.note}"
            value = 1e3 * part.seconds / num_pushes
            yield Measurement(f"{self.name}, {part.name}", value, "ms/push", share)
        cores = self._sum("cpu_s") / total_s
        yield Measurement(f"{self.name}, cores", cores, "", "processor time in the time taken")
        memory = max(turn.peak_bytes for turn in self._turns) / 2**20
        note = "resident, trainer and workers; a replay buffer fills up later"
        yield Measurement(f"{self.name}, peak memory", memory, "MiB", note)

    def _sum(self, name: str) -> float:
        return float(sum(getattr(turn, name) for turn in self._turns))


@dataclass(frozen=True)
class _Part:
    name: str
    seconds: float
    note: str


def _parts(turns: Sequence["TrainingTime"], is_local: bool) -> Iterator[_Part]:
    """Where the trainer's time went; the parts of a local environment instead of their sum."""
    spent = {name: sum(turn.parts_s[name] for turn in turns) for name in turns[0].parts_s}
    environment, update = spent["environment"], spent["update"]
    if is_local:
        yield _Part("physics", spent["physics"], "the push")
        yield _Part("image", spent["image"], "the camera's pictures")
        yield _Part("perception", spent["perception"], "distance map and segments")
        rest = environment - spent["physics"] - spent["image"] - spent["perception"]
        yield _Part("rest of the environment", rest, "placing blocks, rewards, Python")
    else:
        yield _Part("waiting", environment, "for the workers, and the messages")
    yield _Part("update", update, "training the networks")
    acting = sum(turn.total_s for turn in turns) - environment - update
    yield _Part("acting", acting, "the rest: choosing and storing pushes")


def _count(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


_training: "TimedTraining"
"""Of a benchmark's child process."""


def _begin(config: TrainingConfig) -> None:
    global _training
    from singulate.bench.training_time import TimedTraining

    _training = TimedTraining(config)


def _warm_up() -> None:
    _training.warm_up()


def _run(seconds: float) -> "TrainingTime":
    return _training.run(seconds)


def _time_gradient_steps(seconds: float) -> tuple[float, float]:
    return _training.time_gradient_steps(seconds)
