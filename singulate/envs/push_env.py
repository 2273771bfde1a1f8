"""``singulate/Push-v0``: tell blocks apart by pushing them."""

from typing import Any, ClassVar

import gymnasium
import numpy as np
import numpy.typing as npt

from singulate.envs.actions import make_action_encoding
from singulate.envs.config import EnvConfig
from singulate.envs.observations import make_observation
from singulate.envs.push_task import PushResult, PushTask
from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import Poses, Push, parse_layout
from singulate.perception import Percept
from singulate.rewards import TERMS, is_success, make_reward
from singulate.simulation import PushOutcome, make_scenario


class PushEnv(gymnasium.Env[Any, Any]):
    """Push blocks that touch until a camera can tell them apart.

    ## Action Space
    ``action="grid"``: Discrete(400), direction * 100 + row * 10 + column (paper, section 5.4).
    ``action="point"``: Box(-1, 1, (3,)), x / l, y / l and c, where four equal bins of c pick the
    direction up, right, down, left (section 3.2.2).
    ``action="start_end"``: Box(-1, 1, (4,)), start and end divided by l (section 5).

    ## Observation Space
    ``observation="distance_map"``: float32 (64, 64), pixels to the closest object, -1 inside
    (section 3.1). ``observation="mask"``: float32 (64, 64), 1 where an object is (section 5).

    ## Rewards
    A weighted sum of r_Start, r_Dist, r_Inside and r_Success (Eqs. 3 to 7). ``reward="paper"``:
    all four; ``"separation"``: r_Dist alone; ``"start"``: r_Start and r_Inside;
    ``"start_then_separation"``: the schedule of section 5.2.

    ## Starting State
    ``reset(seed=...)`` lets the scenario draw the blocks; ``reset(options={"blocks": [...]})``
    puts up given ones, each ``{"x", "y", "side", "yaw"}`` in metres and radians.

    ## Episode End
    Terminates with success, with a block off the table, or, where ``max_pushes`` is 1 (the paper's
    task), after the push. Truncates after ``max_pushes``, or when the physics went wrong
    (``info["simulation_error"]`` then says how).

    ## Information
    ``mask`` bool (64, 64), ``num_segments``, ``inter_object_distance`` (d_IOT [m]),
    ``is_success``, ``poses`` (block poses at rest, for replay, not for learning); of a step also
    ``reward_terms`` (unweighted, by name), ``push``, ``outcome`` and ``poses_before``.

    Args:
        render_mode: ``rgb_array`` or None.
        **settings: The fields of `EnvConfig`.

    Raises:
        InvalidValueError: If a setting, an option or an action is not allowed.
    """

    metadata: ClassVar[dict[str, Any]] = {  # type: ignore[misc]
        "render_modes": ["rgb_array"],
        "render_fps": 4,
    }

    def __init__(self, render_mode: str | None = None, **settings: Any) -> None:
        if render_mode not in (None, "rgb_array"):
            raise InvalidValueError("render_mode", render_mode, "rgb_array, or None")
        self.config = EnvConfig.from_dict(settings)
        self.render_mode = render_mode
        self.task = PushTask(goal_separation=self.config.goal_separation, exact=self.config.exact)
        self.num_pushes = 0
        """Pushes over this environment's life, which the reward's schedule counts."""
        self._scenario = make_scenario(self.config.scenario)
        self._reward = make_reward(self.config.reward)
        self._actions = make_action_encoding(self.config.action, self.task.workspace)
        self._observation = make_observation(self.config.observation, self.task.workspace)
        self.action_space = self._actions.space
        self.observation_space = self._observation.space
        self._episode_pushes = 0

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[npt.NDArray[np.float32], dict[str, Any]]:
        """Put up a new scene; see the class for `options`."""
        super().reset(seed=seed)
        unknown = sorted(set(options or {}) - {"blocks"})
        if unknown:
            raise InvalidValueError("options", unknown[0], "the key blocks")
        workspace = self.task.workspace
        if options and "blocks" in options:
            layout = parse_layout(options["blocks"], workspace)
        else:
            layout = self._scenario.sample(self.np_random, workspace)
        self.task.place(layout)
        self._episode_pushes = 0
        percept = self.task.percept
        return self._observation.observe(percept), self._info(percept)

    def step(
        self, action: Any
    ) -> tuple[npt.NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Push once; see the class for what comes back."""
        if not self.task.scene.poses:
            raise gymnasium.error.ResetNeeded("call reset before step")
        push = self._actions.decode(action)
        poses_before = self.task.scene.poses
        error = ""
        try:
            result = self.task.execute(push)
        except SimulationError as failure:
            result, error = _nothing_happened(push, self.task.percept), str(failure)
        return self._conclude(result, poses_before, error)

    def lose(
        self, action: Any, error: str
    ) -> tuple[npt.NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Truncate the episode by a push that cannot be simulated; nothing moves.

        Args:
            action: The push that was wanted.
            error: What went wrong, for ``info["simulation_error"]``.
        """
        nothing = _nothing_happened(self._actions.decode(action), self.task.percept)
        return self._conclude(nothing, self.task.scene.poses, error)

    def encode(self, push: Push) -> Any:
        """The action that comes closest to a push, such as one that a policy chose."""
        return self._actions.encode(push)

    def render(self) -> npt.NDArray[np.uint8] | None:
        """A picture of the table, uint8 (360, 480, 3), where `render_mode` is ``rgb_array``."""
        return self.task.scene.picture() if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        """Release the physics engine."""
        self.task.close()

    def _conclude(
        self, result: PushResult, poses_before: Poses, error: str
    ) -> tuple[npt.NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        reward_index, self.num_pushes = self.num_pushes, self.num_pushes + 1
        self._episode_pushes += 1
        info = self._info(result.after) | {
            "reward_terms": result.terms,
            "push": result.push,
            "outcome": result.outcome,
            "poses_before": poses_before,
        }
        if error:
            info["simulation_error"] = error
        is_over = result.is_success or bool(result.outcome.fallen)
        is_last = self._episode_pushes >= self.config.push_limit
        terminated = not error and (is_over or (is_last and self.config.push_limit == 1))
        truncated = bool(error) or (is_last and not terminated)
        reward = self._reward.total(result.terms, reward_index)
        return self._observation.observe(result.after), reward, terminated, truncated, info

    def _info(self, percept: Percept) -> dict[str, Any]:
        poses: Poses = self.task.scene.poses
        goal = self.config.goal_separation
        return {
            "mask": percept.mask.copy(),
            "num_segments": percept.num_segments,
            "inter_object_distance": percept.inter_object_distance_truncated(goal),
            "is_success": is_success(percept, self.task.num_blocks, goal),
            "poses": poses,
        }


def _nothing_happened(push: Push, percept: Percept) -> PushResult:
    return PushResult(push, percept, percept, PushOutcome(), dict.fromkeys(TERMS, 0.0), False)
