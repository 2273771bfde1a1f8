"""Trains for a while with a stopwatch."""

import os
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import torch
from stable_baselines3 import DQN
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.vec_env import VecEnvWrapper
from stable_baselines3.common.vec_env.base_vec_env import VecEnvObs, VecEnvStepReturn

from singulate.agents.dqn.model import GridDQN
from singulate.bench.memory import memory_of
from singulate.envs import push_task
from singulate.simulation import Scene
from singulate.training.config import TrainingConfig
from singulate.training.envs import make_training_envs
from singulate.training.model import build_training_model
from singulate.training.workers.worker_envs import WorkerEnvs


@dataclass
class TrainingTime:
    """What a training took.

    Attributes:
        num_pushes: Pushes that were timed.
        total_s: Time for them [s].
        cpu_s: Processor time for them, of the trainer and its workers [s].
        parts_s: Part of the time that the trainer spent in each of `PARTS` [s].
        peak_bytes: Largest resident memory of the trainer and its workers [bytes].
    """

    num_pushes: int = 0
    total_s: float = 0.0
    cpu_s: float = 0.0
    parts_s: dict[str, float] = field(default_factory=dict)
    peak_bytes: int = 0


_STEPS_A_TURN = 10

PARTS = ("environment", "update", "physics", "image", "perception")
"""The last three are in the first, and are seen of an environment in the trainer alone."""


class TimedTraining:
    """A training that goes on for as long as it is asked to, without record and checkpoints.

    Args:
        config: What to train; `total_timesteps` is beyond reach.
    """

    def __init__(self, config: TrainingConfig) -> None:
        torch.set_num_threads(config.num_threads)
        torch.set_flush_denormal(True)
        self.config = config
        self._spent = dict.fromkeys(PARTS, 0.0)
        self._envs = make_training_envs(config)
        self.model = build_training_model(config, _TimedEnvs(self._envs, self._spent))
        update = "update" if hasattr(self.model, "update") else "train"
        self._time(self.model, update, "update")
        if not self.worker_pids:
            self._time(Scene, "push", "physics")
            self._time(Scene, "photograph_blocks", "image")
            self._time(push_task, "perceive", "perception")

    @property
    def worker_pids(self) -> list[int]:
        """Processes that the environments live in; none where they are in this one."""
        return self._envs.pids if isinstance(self._envs, WorkerEnvs) else []

    def warm_up(self) -> None:
        """Train until the networks have been updated once."""
        num_pushes = int(getattr(self.model, "learning_starts", 0)) + 2 * self.config.num_envs
        self._learn(lambda: self.model.num_timesteps >= max(num_pushes, 1))

    def run(self, seconds: float) -> TrainingTime:
        """Train on, and time whole rollouts with their updates.

        Args:
            seconds: The first rollout that would begin so long from now does not [s].
        """
        before, num_before, cpu_before = dict(self._spent), self.model.num_timesteps, self._cpu_s()
        began = time.perf_counter()
        self._learn(lambda: time.perf_counter() - began >= seconds)
        return TrainingTime(
            self.model.num_timesteps - num_before,
            time.perf_counter() - began,
            self._cpu_s() - cpu_before,
            {part: self._spent[part] - before[part] for part in PARTS},
            sum(memory_of(pid).peak_bytes for pid in (os.getpid(), *self.worker_pids)),
        )

    def time_gradient_steps(self, seconds: float) -> tuple[float, float]:
        """Time of a gradient step of a DQN, ours and stable-baselines3's, in turns [s].

        Args:
            seconds: How long to measure [s].
        """
        assert isinstance(self.model, GridDQN)
        model, spent, num_turns = self.model, [0.0, 0.0], 0
        while sum(spent) < seconds:
            moments = [time.perf_counter()]
            model.update(_STEPS_A_TURN)
            moments.append(time.perf_counter())
            DQN.train(model, _STEPS_A_TURN, model.batch_size)
            moments.append(time.perf_counter())
            steps = zip(spent, pairwise(moments), strict=True)
            spent = [total + end - begin for total, (begin, end) in steps]
            num_turns += 1
        num_steps = num_turns * _STEPS_A_TURN
        return spent[0] / num_steps, spent[1] / num_steps

    def _learn(self, is_enough: Callable[[], bool]) -> None:
        with suppress(_TimeIsUp):
            self.model.learn(
                self.config.total_timesteps,
                callback=_Stop(is_enough),
                reset_num_timesteps=False,
                log_interval=None,  # type: ignore[arg-type]
            )

    def _cpu_s(self) -> float:
        return time.process_time() + sum(_cpu_of(pid) for pid in self.worker_pids)

    def _time(self, owner: Any, name: str, part: str) -> None:
        """Add up the time in a function of this process."""
        function = getattr(owner, name)

        def timed(*args: Any, **kwargs: Any) -> Any:
            began = time.perf_counter()
            result = function(*args, **kwargs)
            self._spent[part] += time.perf_counter() - began
            return result

        setattr(owner, name, timed)


class _TimedEnvs(VecEnvWrapper):
    """Adds up the time that the trainer spends on its environments [s]."""

    def __init__(self, envs: Any, spent: dict[str, float]) -> None:
        super().__init__(envs)
        self._spent = spent

    def reset(self) -> VecEnvObs:
        return self.venv.reset()

    def step_async(self, actions: Any) -> None:
        began = time.perf_counter()
        self.venv.step_async(actions)
        self._spent["environment"] += time.perf_counter() - began

    def step_wait(self) -> VecEnvStepReturn:
        began = time.perf_counter()
        result = self.venv.step_wait()
        self._spent["environment"] += time.perf_counter() - began
        return result


class _TimeIsUp(Exception):  # noqa: N818 - no error: leaves stable-baselines3's loop
    """Raised between two rollouts."""


class _Stop(BaseCallback):
    """Ends a training between two rollouts."""

    def __init__(self, is_enough: Callable[[], bool]) -> None:
        super().__init__()
        self._is_enough = is_enough

    def _on_rollout_start(self) -> None:
        if self._is_enough():
            raise _TimeIsUp

    def _on_step(self) -> bool:
        return True


def _cpu_of(pid: int) -> float:
    """Processor time of a process [s]; 0 where there is no /proc."""
    path = Path(f"/proc/{pid}/stat")
    if not path.exists():
        return 0.0
    user, system = path.read_text().rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
