"""Environments and network that work at the same time."""

from collections.abc import Callable

from stable_baselines3.common.off_policy_algorithm import OffPolicyAlgorithm
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


class OverlappedUpdates(OffPolicyAlgorithm):
    """Learns between two pushes of one environment, or while several environments push."""

    def update(self, gradient_steps: int) -> None:
        """Improve the network by so many gradient steps."""
        raise NotImplementedError

    def train(self, gradient_steps: int, batch_size: int = 100) -> None:
        """Update the network, or leave it to `update_meanwhile`."""
        if self.n_envs == 1:
            self.update(gradient_steps)

    def update_meanwhile(self) -> None:
        """Make the update that is due after the last pushes, while the next ones are made."""
        if self.num_timesteps > self.learning_starts:
            self.update(self.gradient_steps)
