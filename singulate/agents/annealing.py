"""Settings that change with the number of pushes.

stable-baselines3 ties its schedules to the share of the training that is done, so extending a run
would change its past. Here they depend on the number of pushes alone.
"""

from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.utils import update_learning_rate
from torch.optim import Optimizer


def annealed(start: float, end: float, num_pushes: int, over: int) -> float:
    """A setting that goes linearly from `start` to `end` over so many pushes, and stays there."""
    done = min(num_pushes / over, 1.0)
    return start + done * (end - start)


def set_learning_rate(
    model: BaseAlgorithm, optimizers: list[Optimizer] | Optimizer, rate: float
) -> None:
    """Give optimizers a step size and record it with the model's metrics."""
    model.logger.record("train/learning_rate", rate)
    for optimizer in optimizers if isinstance(optimizers, list) else [optimizers]:
        update_learning_rate(optimizer, rate)
