"""The one interactive scene: what is on the table, the push under way, and the way back."""

from collections.abc import Generator
from dataclasses import dataclass, replace

import numpy as np

from app.commands import ArrangeBlocks
from app.processes.arranging import Hands
from app.processes.push_reports import report_of
from app.processes.scene_messages import (
    FinishedPush,
    LiveState,
    RestState,
    SavedScene,
    SceneStart,
    StartPush,
)
from app.scene_recipe import check_recipe
from singulate.envs.push_task import PushTask
from singulate.exceptions import InvalidValueError, SimulationError
from singulate.geometry import Poses
from singulate.perception import Percept
from singulate.rewards import RewardFunction, is_success, make_reward
from singulate.simulation import PushFrame, PushOutcome, make_scenario
from singulate.simulation.fallen import is_fallen

MAX_HISTORY = 50


@dataclass
class _ActivePush:
    request: StartPush
    before: Percept
    steps: Generator[PushFrame, None, PushOutcome]
    poses: Poses
    pusher: tuple[float, float, float, float] | None = None


class LiveScene:
    """Owns the Bullet world that people and the loaded policy push in.

    Args:
        start: The recipe, or the saved scene, to begin with.

    Raises:
        InvalidValueError: If the recipe is not allowed.
    """

    def __init__(self, start: SceneStart) -> None:
        self._task = PushTask()
        self._reward: RewardFunction = make_reward("paper")
        self._active: _ActivePush | None = None
        self._hands = Hands(self._task.workspace)
        self._history: list[SavedScene] = []
        self._version = start.version - 1
        self.motion_count = 0
        self.speed = start.speed
        self.is_paused = start.is_paused
        if start.saved is None:
            self.reset(start.scenario, start.seed)
        else:
            self._history = list(start.history)
            self._put_up(start.saved)

    @property
    def is_pushing(self) -> bool:
        """Whether a push is under way, frozen or not."""
        return self._active is not None

    def reset(self, scenario: str, seed: int) -> None:
        """Put up a fresh scene; there is no way back to the one before.

        Raises:
            InvalidValueError: If there is no such scenario, or the seed is out of range.
        """
        check_recipe(scenario, seed)
        layout = make_scenario(scenario).sample(np.random.default_rng(seed), self._task.workspace)
        self._drop_push()
        self._hands.let_go()
        self._history.clear()
        self._task.place(layout)
        self._changed(SavedScene(scenario, seed, len(layout), self._task.scene.poses, 0))

    def undo(self) -> None:
        """Return to before the last push or move by hand, or to before the push under way."""
        self._hands.let_go()
        if self._active is not None:
            self._drop_push()
            self._put_up(self._scene)
        elif self._history:
            self._put_up(self._history.pop())

    def begin(self, request: StartPush) -> None:
        """Lower the pusher; ignored while another push is under way.

        Raises:
            InvalidValueError: If the push starts outside the workspace or is longer than it.
        """
        if self._active is not None:
            return
        push, workspace = request.push, self._task.workspace
        half = workspace.half_length
        if not workspace.contains(*push.start):
            raise InvalidValueError(
                "push.start", push.start, f"within {half} m of the centre lines"
            )
        if push.length > workspace.diagonal:
            raise InvalidValueError("push.length", push.length, f"0 to {workspace.diagonal:.2f} m")
        self._hands.let_go()
        self._active = _ActivePush(
            request, self._task.percept, self._task.scene.push_steps(push), self._scene.poses
        )

    def arrange(self, command: ArrangeBlocks) -> None:
        """Move, add or remove blocks by hand; ignored while a push is under way.

        What stands then is a new start: its pushes are counted from zero.

        Raises:
            InvalidValueError: If a value is not allowed, or there is no room.
        """
        before = self._scene
        change = None if self._active else self._hands.arrange(command, before.poses)
        if change is None:
            return
        if change.is_new_step:
            self._history = [*self._history, before][-MAX_HISTORY:]
        self._put_up(
            replace(
                before,
                num_blocks=len(change.poses),
                poses=change.poses,
                num_pushes=0,
                is_rearranged=True,
            )
        )

    def step(self) -> FinishedPush | None:
        """Advance the push under way by one simulation step.

        Returns:
            The push, once it is finished.

        Raises:
            SimulationError: If the physics went wrong; the scene is as before the push.
        """
        active = self._active
        if active is None:
            return None
        try:
            active.poses, active.pusher = next(active.steps)
            self.motion_count += 1
            return None
        except StopIteration as stop:
            return self._finish(active, stop.value)
        except SimulationError:
            self._drop_push()
            self._put_up(self._scene)
            raise

    def live(self) -> LiveState:
        """What moves, as it is now."""
        active, hold = self._active, self._hands.newest
        return LiveState(
            poses=active.poses if active else self._scene.poses,
            pusher=active.pusher if active else None,
            active_push=active.request.push if active else None,
            pushed_by=active.request.by if active else "",
            is_paused=self.is_paused,
            speed=self.speed,
            motion_count=self.motion_count,
            held_block=hold.index if hold else None,
            held_by=hold.by if hold else "",
        )

    def rest(self) -> RestState:
        """The scene as it was when it last came to rest."""
        return self._rest

    def close(self) -> None:
        """Release the physics engine."""
        self._task.close()

    def _finish(self, active: _ActivePush, outcome: PushOutcome) -> FinishedPush:
        request, before = active.request, self._scene
        self._active = None
        result = self._task.score(request.push, active.before, outcome)
        self._history = [*self._history, before][-MAX_HISTORY:]
        self._changed(
            replace(before, poses=self._task.scene.poses, num_pushes=before.num_pushes + 1)
        )
        return FinishedPush(request.push_id, report_of(result, self._reward, request.by))

    def _drop_push(self) -> None:
        if self._active is not None:
            self._active.steps.close()
            self._active = None

    def _put_up(self, scene: SavedScene) -> None:
        self._task.restore(scene.poses)
        self._changed(scene)

    def _changed(self, scene: SavedScene) -> None:
        self._version += 1
        self._scene = scene
        percept = self._task.percept
        self._rest = RestState(
            version=self._version,
            scene=scene,
            history=tuple(self._history),
            max_pushes=make_scenario(scene.scenario).default_max_pushes,
            percept=percept,
            rgb=self._task.scene.photograph().rgb,
            is_success=is_success(percept, scene.num_blocks, self._task.goal_separation),
            has_fallen=any(is_fallen(pose) for pose in scene.poses),
        )
