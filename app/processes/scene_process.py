"""The scene process: plays pushes in real time and tells the laboratory what it sees."""

import time
from collections.abc import Callable

from app.commands import ArrangeBlocks, ResetScene, SetScenePaused, SetSpeed, StepScene, Undo
from app.processes.live_scene import LiveScene
from app.processes.pipes import Pipe, has_room
from app.processes.scene_messages import (
    FinishedPush,
    Refused,
    SceneStart,
    SceneUpdate,
    StartPush,
)
from singulate.exceptions import SingulateError
from singulate.simulation import Physics

_FRAME_S = 1 / 60
_MAX_LAG_S = 0.1
"""Playback that falls behind by more than this slows down instead of jumping."""


def run_scene(connection: Pipe, start: SceneStart) -> None:
    """Serve the interactive scene until the pipe is closed.

    Args:
        connection: Pipe to the laboratory; see `scene_messages`.
        start: The scene to begin with.
    """
    scene = LiveScene(start)
    try:
        ScenePlayer(scene, connection).play()
    finally:
        scene.close()


class ScenePlayer:
    """Advances the scene at its playback speed, between commands.

    Args:
        scene: The scene.
        connection: Where commands come from and updates go.
    """

    def __init__(self, scene: LiveScene, connection: Pipe) -> None:
        self._scene = scene
        self._connection = connection
        self._step_s = Physics().time_step
        self._due_s = 0.0
        self._played_at = time.perf_counter()
        self._sent_at = 0.0
        self._sent_version = 0

    def play(self) -> None:
        """Run until the pipe is closed (`EOFError`)."""
        self._report(None, is_news=True)
        while True:
            finished, is_news = None, False
            if self._connection.poll(self._time_to_next_step()):
                finished, is_news = self._obey(self._connection.recv()), True
            if self._is_moving:
                finished = self._advance()
            self._report(finished, is_news=is_news or finished is not None)

    @property
    def _is_moving(self) -> bool:
        return self._scene.is_pushing and not self._scene.is_paused

    def _time_to_next_step(self) -> float | None:
        if not self._is_moving:
            return None
        elapsed = time.perf_counter() - self._played_at
        return max(0.0, min(self._due_s / self._scene.speed - elapsed, _FRAME_S))

    def _obey(self, command: object) -> FinishedPush | None:
        was_moving = self._is_moving
        finished = self._try(lambda: self._carry_out(command))
        if self._is_moving and not was_moving:
            self._restart_clock()
        return finished

    def _carry_out(self, command: object) -> FinishedPush | None:
        scene = self._scene
        match command:
            case StartPush():
                scene.begin(command)
            case ResetScene(scenario, seed):
                scene.reset(scenario, seed)
            case Undo():
                scene.undo()
            case _ if isinstance(command, ArrangeBlocks):
                scene.arrange(command)
            case SetScenePaused(is_paused):
                scene.is_paused = is_paused
            case StepScene():
                return scene.step() if scene.is_paused else None
            case SetSpeed(factor):
                self._restart_clock()
                scene.speed = factor
        return None

    def _advance(self) -> FinishedPush | None:
        """Run the simulation steps that are due, for one frame at most."""
        now = time.perf_counter()
        elapsed = (now - self._played_at) * self._scene.speed
        self._due_s = max(self._due_s, elapsed - _MAX_LAG_S * self._scene.speed)
        while self._is_moving and self._due_s <= elapsed:
            self._due_s += self._step_s
            finished = self._try(self._scene.step)
            if finished is not None or time.perf_counter() > now + _FRAME_S:
                return finished
        return None

    def _try(self, act: Callable[[], FinishedPush | None]) -> FinishedPush | None:
        try:
            return act()
        except SingulateError as error:
            self._connection.send(Refused(str(error)))
            return None

    def _restart_clock(self) -> None:
        self._played_at, self._due_s = time.perf_counter(), 0.0

    def _report(self, finished: FinishedPush | None, *, is_news: bool) -> None:
        """Send what is new; a mere frame is left out when it is early or nobody reads."""
        now = time.perf_counter()
        rest = self._scene.rest()
        is_changed = rest.version != self._sent_version
        is_frame_due = self._is_moving and now - self._sent_at >= _FRAME_S
        if not (is_news or is_changed or (is_frame_due and has_room(self._connection))):
            return
        self._sent_at, self._sent_version = now, rest.version
        update = SceneUpdate(self._scene.live(), rest if is_changed else None, finished)
        self._connection.send(update)
