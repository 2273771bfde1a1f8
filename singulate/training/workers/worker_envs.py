"""The environments of a training in worker processes, as stable-baselines3 wants them."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from stable_baselines3.common.vec_env import VecEnv
from stable_baselines3.common.vec_env.base_vec_env import VecEnvStepReturn

from singulate.envs import make_action_encoding, make_observation
from singulate.geometry import Workspace
from singulate.training.config import TrainingConfig
from singulate.training.episode_state import EpisodeState
from singulate.training.workers.messages import Act, Acted, Restore, Settings
from singulate.training.workers.supervisor import Supervisor, WorkerLoss

Observations = npt.NDArray[np.float32]


class WorkerEnvs(VecEnv):
    """A vector environment whose workers may be killed, stopped or hang.

    Results are the same for every number of workers, and whichever answers first. Beside
    `SubprocVecEnv`, which waits for ever for a worker that is stopped and leaves the others behind
    when one is killed, a lost worker is replaced; see `Supervisor`.

    Args:
        config: The run's settings.
        num_workers: Processes.
    """

    def __init__(self, config: TrainingConfig, num_workers: int) -> None:
        self.config = config
        workspace = Workspace()
        super().__init__(
            config.num_envs,
            make_observation(config.env.observation, workspace).space,
            make_action_encoding(config.env.action, workspace).space,
        )
        states = [EpisodeState.initial(index, self.num_envs) for index in range(self.num_envs)]
        self._supervisor = Supervisor(Settings(config.env, config.seed), states, num_workers)

    @property
    def states(self) -> list[EpisodeState]:
        """Where each environment is, for `restore`."""
        return list(self._supervisor.states)

    @property
    def pids(self) -> list[int]:
        """Process ids of the workers."""
        return self._supervisor.pids

    def restore(self, states: Sequence[EpisodeState]) -> Observations:
        """Return to states and give their observations, float32 (num_envs, H, W).

        Raises:
            WorkerError: If workers cannot be started.
        """
        self._supervisor.request([Restore(index, state) for index, state in enumerate(states)])
        return np.stack([answer.observation for answer in self._supervisor.gather()])

    def take_losses(self) -> list[WorkerLoss]:
        """Workers that were replaced since the last call."""
        losses, self._supervisor.losses = self._supervisor.losses, []
        return losses

    def reset(self) -> Observations:
        """Begin the next episodes; see `restore`."""
        return self.restore([state.after_reset() for state in self.states])

    def step_async(self, actions: npt.NDArray[Any]) -> None:
        """Let the workers push."""
        self._supervisor.request([Act(index, action) for index, action in enumerate(actions)])

    def step_wait(self) -> VecEnvStepReturn:
        """Wait for all pushes.

        Raises:
            WorkerError: If an environment raised, or workers cannot be kept alive.
        """
        acted = [answer for answer in self._supervisor.gather() if isinstance(answer, Acted)]
        return (
            np.stack([answer.observation for answer in acted]),
            np.array([answer.reward for answer in acted], dtype=np.float32),
            np.array([answer.is_done for answer in acted]),
            [answer.info for answer in acted],
        )

    def close(self) -> None:
        """End the workers."""
        self._supervisor.close()

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Of the attributes in the workers none is known but that they do not render."""
        if attr_name != "render_mode":
            raise AttributeError(f"{attr_name}: not known of environments in worker processes")
        return [None for _ in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Refused: a worker that is replaced would not know of it."""
        raise AttributeError(f"{attr_name}: cannot be set in worker processes")

    def env_method(
        self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any
    ) -> list[Any]:
        """Refused: a worker that is replaced would not know of it."""
        raise AttributeError(f"{method_name}: cannot be called in worker processes")

    def env_is_wrapped(self, wrapper_class: type[Any], indices: Any = None) -> list[bool]:
        """Never by a wrapper that stable-baselines3 asks for."""
        return [False for _ in self._get_indices(indices)]
