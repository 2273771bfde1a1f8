"""Environments and network that work at the same time."""

from collections.abc import Callable

from stable_baselines3.common.vec_env import VecEnvWrapper
from stable_baselines3.common.vec_env.base_vec_env import VecEnvObs, VecEnvStepReturn


class OverlappedSteps(VecEnvWrapper):
    """Calls something between telling the environments to push and waiting for them.

    Attributes:
        meanwhile: What is called.
    """

    meanwhile: Callable[[], None]

    def reset(self) -> VecEnvObs:
        """Begin new episodes."""
        return self.venv.reset()

    def step_wait(self) -> VecEnvStepReturn:
        """Use the time, then wait."""
        self.meanwhile()
        return self.venv.step_wait()
