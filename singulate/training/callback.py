"""The hook into stable-baselines3's learning loop."""

from typing import Any

import numpy as np
import numpy.typing as npt
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.on_policy_algorithm import OnPolicyAlgorithm

from singulate.agents.reward_scale import REWARD_SCALE
from singulate.training.session import TrainingSession


class SessionCallback(BaseCallback):
    """Passes pushes and safe points on to a session.

    stable-baselines3 calls `_on_step` before a transition is stored, so the safe points, at which
    a checkpoint holds everything, are the beginnings of rollouts: every push where a replay memory
    is learnt from.

    Args:
        session: The training under way.
    """

    def __init__(self, session: TrainingSession) -> None:
        super().__init__()
        self._session = session

    def _on_rollout_start(self) -> None:
        self._session.at_safe_point()

    def _on_step(self) -> bool:
        infos: list[dict[str, Any]] = self.locals["infos"]
        results = zip(infos, self._predicted(), self.locals["dones"], strict=True)
        for index, (info, predicted, is_done) in enumerate(results):
            self._session.after_push(index, info, float(predicted), bool(is_done))
        self._session.note_losses()
        if isinstance(self.model, OnPolicyAlgorithm):
            self._session.between_pushes()
        return True

    def _predicted(self) -> npt.NDArray[np.float64]:
        """Expected rewards of the executed pushes: V or Q, in reward units."""
        if isinstance(self.model, OnPolicyAlgorithm):
            values = self.locals["values"][:, 0].numpy()
        else:
            values = self.model.predicted_values  # type: ignore[attr-defined]
        return np.asarray(values, dtype=np.float64) / REWARD_SCALE
