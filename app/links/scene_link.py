"""The laboratory's end of the scene process."""

from collections.abc import Callable
from dataclasses import replace

from app.notices import NoticeBoard
from app.processes.scene_messages import (
    FinishedPush,
    LiveState,
    Refused,
    RestState,
    SceneStart,
    SceneUpdate,
)
from app.processes.supervised import SupervisedProcess

_ANSWER_TIMEOUT_S = 15.0


class SceneLink:
    """Keeps the scene alive: a killed process comes back with the same table.

    Args:
        scenario: Recipe of the first scene.
        seed: Seed of the first scene.
        notices: Where problems are told.
        on_message: Called from another thread when something has arrived.
    """

    def __init__(
        self,
        scenario: str,
        seed: int,
        notices: NoticeBoard,
        on_message: Callable[[], None],
    ) -> None:
        self._first = SceneStart(scenario, seed)
        self._notices = notices
        self.live: LiveState | None = None
        self.rest: RestState | None = None
        self._motion_before_restart = 0
        self._process = SupervisedProcess(
            "The scene process",
            "app.processes.scene_process:run_scene",
            arguments=lambda: (self._start(),),
            on_message=on_message,
            answer_timeout_s=_ANSWER_TIMEOUT_S,
        )

    @property
    def pid(self) -> int:
        """Process id of the scene process."""
        return self._process.pid

    @property
    def is_pushing(self) -> bool:
        """Whether a push is under way, frozen or not."""
        return self.live is not None and self.live.active_push is not None

    @property
    def is_held(self) -> bool:
        """Whether somebody has a block in the hand."""
        return self.live is not None and self.live.held_block is not None

    def send(self, command: object) -> None:
        """Pass a command on; a process that cannot take it is told about on the page."""
        if not self._process.send(command):
            self._notices.add(
                f"The scene process did not take {type(command).__name__}; try again in a moment."
            )

    def update(self) -> list[FinishedPush]:
        """Take in what has arrived, and see that the process lives.

        Returns:
            Pushes that have been finished since the last call.
        """
        finished = [push for message in self._process.receive() for push in self._hear(message)]
        explanation = self._process.watch()
        if explanation is not None:
            self._forget_push()
            self._notices.add(f"{explanation} The table is as it was at rest; push again.")
        return finished

    def close(self) -> None:
        """End the process."""
        self._process.close()

    def _hear(self, message: object) -> list[FinishedPush]:
        if isinstance(message, Refused):
            self._notices.add(message.reason)
        elif isinstance(message, SceneUpdate):
            count = message.live.motion_count + self._motion_before_restart
            self.live = replace(message.live, motion_count=count)
            self.rest = message.rest or self.rest
            if message.finished is not None:
                return [message.finished]
        return []

    def _start(self) -> SceneStart:
        if self.rest is None or self.live is None:
            return self._first
        return SceneStart(
            self.rest.scene.scenario,
            self.rest.scene.seed,
            saved=self.rest.scene,
            history=self.rest.history,
            version=self.rest.version + 1,
            speed=self.live.speed,
            is_paused=self.live.is_paused,
        )

    def _forget_push(self) -> None:
        if self.live is None or self.rest is None:
            return
        self._motion_before_restart = self.live.motion_count
        poses = self.rest.scene.poses
        self.live = replace(
            self.live, poses=poses, pusher=None, active_push=None, pushed_by="",
            held_block=None, held_by="",
        )  # fmt: skip
