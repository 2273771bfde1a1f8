"""An environment without physics: every push was made when its data set was built."""

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt

from singulate.datasets.recorded_scenes import RecordedScene, RecordedScenes
from singulate.envs import EnvConfig, make_action_encoding, make_observation
from singulate.exceptions import InvalidValueError
from singulate.geometry import Poses, Push, Workspace, standing_pose
from singulate.outcomes import OUTCOMES
from singulate.perception import percept_of_mask
from singulate.rewards import TERMS, make_reward, object_distance, start_reward
from singulate.simulation import PushOutcome


class RecordedPushEnv(gymnasium.Env[Any, Any]):
    """``singulate/Push-v0`` on recorded scenes, one push an episode: a contextual bandit.

    Spaces, observations and rewards are those of `PushEnv`, so every agent can learn in it. A push
    is answered with what its data set recorded for the nearest start and direction, rewards rounded
    to 16 bits. What the scene looks like afterwards was not recorded: the observation of a step is
    that before it, which no agent looks at, because the episode is over.

    Args:
        scenes: The data set.
        config: The task: the data set's, with single pushes; see `recorded_env_config`.

    Raises:
        InvalidValueError: If the data set cannot answer for this task.
    """

    def __init__(self, scenes: RecordedScenes, config: EnvConfig) -> None:
        wanted = recorded_env_config(scenes, config.observation, config.action)
        if config != wanted:
            raise InvalidValueError("env", config, f"what the data set was made for, {wanted}")
        self.config = config
        self.num_pushes = 0
        """Pushes over this environment's life."""
        self._scenes = scenes
        self._workspace = Workspace()
        self._reward = make_reward(config.reward)
        self._actions = make_action_encoding(config.action, self._workspace)
        self._observation = make_observation(config.observation, self._workspace)
        self.action_space = self._actions.space
        self.observation_space = self._observation.space
        self._scene: RecordedScene | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        """Choose a recorded scene; there are no `options`."""
        super().reset(seed=seed)
        if options:
            raise InvalidValueError("options", options, "nothing: scenes are recorded ones")
        self._scene = self._scenes[int(self.np_random.integers(len(self._scenes)))]
        self._percept = percept_of_mask(self._scene.mask, self._workspace.metres_per_pixel)
        return self._observation.observe(self._percept), self._info(is_success=False)

    def step(
        self, action: Any
    ) -> tuple[npt.NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Look up what the push was paid."""
        if self._scene is None:
            raise gymnasium.error.ResetNeeded("call reset before step")
        push = self._actions.decode(action)
        size = self._scene.reward_map.shape[1]
        row, col = self._workspace.xy_to_row_col(*push.start, size)
        direction = push.nearest_direction
        start = self._workspace.row_col_to_xy(row, col, size)
        recorded = Push.cardinal(start, direction, self._workspace.push_length)
        reward = float(self._scene.reward_map[direction, row, col])
        outcome = OUTCOMES[self._scene.outcomes[direction, row, col]]
        poses = self._poses
        info = self._info(is_success=outcome == "success") | {
            "reward_terms": self._terms(recorded, reward, outcome),
            "push": recorded,
            "outcome": _push_outcome(outcome),
            "poses_before": poses,
        }
        self.num_pushes += 1
        self._scene = None
        return self._observation.observe(self._percept), reward, True, False, info

    def encode(self, push: Push) -> Any:
        """The action that comes closest to a push."""
        return self._actions.encode(push)

    @property
    def _poses(self) -> Poses:
        return tuple(standing_pose(block) for block in self._scene.layout) if self._scene else ()

    def _terms(self, push: Push, reward: float, outcome: str) -> dict[str, float]:
        """Unweighted terms; what the others leave of the reward was paid for the distance."""
        terms = dict.fromkeys(TERMS, 0.0)
        terms["start"] = start_reward(
            object_distance(self._percept, push, self._workspace), self._workspace
        )
        terms["inside"] = float(outcome == "inside")
        terms["success"] = float(outcome == "success")
        weight = self._reward.weights.get("distance", 0.0)
        if weight:
            terms["distance"] = (reward - self._reward.total(terms)) / weight
        return terms

    def _info(self, is_success: bool) -> dict[str, Any]:
        goal = self.config.goal_separation
        return {
            "mask": self._percept.mask.copy(),
            "num_segments": self._percept.num_segments,
            "inter_object_distance": self._percept.inter_object_distance_truncated(goal),
            "is_success": is_success,
            "poses": self._poses,
        }


def recorded_env_config(scenes: RecordedScenes, observation: str, action: str) -> EnvConfig:
    """The task that a data set can answer for.

    Raises:
        InvalidValueError: If the action encoding has pushes of any length and direction, or a name
            is unknown.
    """
    if action == "start_end":
        allowed = "grid or point: the pushes of a data set have one length and four directions"
        raise InvalidValueError("action", action, allowed)
    recorded = scenes.manifest.config
    return EnvConfig(
        scenario=recorded.scenario,
        observation=observation,
        action=action,
        reward=recorded.reward,
        max_pushes=1,
        goal_separation=recorded.goal_separation,
    )


def _push_outcome(outcome: str) -> PushOutcome:
    """How far blocks moved was not recorded."""
    if outcome == "inside":
        return PushOutcome(is_blocked=True)
    is_empty = outcome == "empty"
    return PushOutcome(is_touching=not is_empty, moved=0.0 if is_empty else float("nan"))
