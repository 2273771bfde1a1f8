"""The hook into stable-baselines3's learning loop."""

from typing import Any

from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.on_policy_algorithm import OnPolicyAlgorithm

from singulate.agents.reward_scale import REWARD_SCALE
from singulate.training.session import TrainingSession


class SessionCallback(BaseCallback):
    """Passes pushes and safe points on to a session.

    stable-baselines3 calls `_on_step` before a transition is stored, so the safe points, at which
    a checkpoint holds everything, are the beginnings of rollouts: every push for a DQN.

    Args:
        session: The training under way.
    """

    def __init__(self, session: TrainingSession) -> None:
        super().__init__()
        self._session = session

    def _on_rollout_start(self) -> None:
        self._session.at_safe_point()

    def _on_step(self) -> bool:
        info: dict[str, Any] = self.locals["infos"][0]
        self._session.after_push(info, self._predicted(), bool(self.locals["dones"][0]))
        if isinstance(self.model, OnPolicyAlgorithm):
            self._session.between_pushes()
        return True

    def _predicted(self) -> float:
        """Expected reward of the executed push: V of PPO, Q of a DQN, in reward units."""
        if isinstance(self.model, OnPolicyAlgorithm):
            return float(self.locals["values"][0, 0]) / REWARD_SCALE
        return float(self.model.predicted_values[0]) / REWARD_SCALE  # type: ignore[attr-defined]
