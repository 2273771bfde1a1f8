"""The laboratory behind the page: one place where its state lives, fed by typed commands."""

import os
import queue
import threading
import time
from collections.abc import Set
from pathlib import Path

from app.commands import (
    AgentPush,
    ArrangeBlocks,
    Command,
    DismissNotice,
    LoadPolicy,
    PushNow,
    ResetScene,
    SetScenePaused,
    SetSpeed,
    SetWatching,
    StepScene,
    Undo,
)
from app.following import Following
from app.links.policy_link import PolicyLink
from app.links.reward_map_link import RewardMapLink
from app.links.scene_link import SceneLink
from app.notices import NoticeBoard
from app.pushing import Pushing
from app.scene_recipe import check_recipe
from app.scene_view import SceneView
from app.snapshot import Snapshot
from app.training_link import TrainingLink
from app.watching import NextMove, Watching
from singulate.exceptions import InvalidValueError, SingulateError
from singulate.finite import is_finite_number
from singulate.paths import default_runs_directory, shipped_checkpoints_directory

FIRST_POLICY = "spatial"
FIELDS = frozenset({"reward_map", "q_map", "start_density"})
SPEED_RANGE = (0.05, 50.0)
_MAX_WAITING_COMMANDS = 1000


class Laboratory:
    """Scene, policy, reward maps and training, each in a process of its own.

    Make it, tick it and close it in the same long-lived thread: the processes die with that
    thread. `submit`, `wake`, `wait` and `set_wanted_fields` may be called from any thread.

    Args:
        scenario: Recipe of the first scene.
        seed: Seed of the first scene.
        runs_dir: Where runs are made and found.
        checkpoints_dir: Where policies that can be loaded are found.
        run_dir: Run to watch from the start; the newest one that is alive otherwise.
        num_workers: Processes for the finer reward maps; they stand back, so by default one a core.

    Raises:
        InvalidValueError: If there is no such scenario, or the seed is out of range.
        RunError: If `run_dir` is given and holds no run.
    """

    def __init__(
        self,
        scenario: str = "random-2",
        seed: int = 0,
        *,
        runs_dir: Path | None = None,
        checkpoints_dir: Path | None = None,
        run_dir: Path | None = None,
        num_workers: int | None = None,
    ) -> None:
        check_recipe(scenario, seed)
        self._commands: queue.Queue[Command] = queue.Queue(_MAX_WAITING_COMMANDS)
        self._news = threading.Event()
        self._wanted: frozenset[str] = frozenset()
        self._notices = NoticeBoard()
        self._view = SceneView()
        self._watching = Watching()
        checkpoints = checkpoints_dir or shipped_checkpoints_directory()
        workers = num_workers or os.cpu_count() or 1
        # First what may refuse its arguments, so that no process is left behind.
        self._training = TrainingLink(
            runs_dir or default_runs_directory(), checkpoints, run_dir, self._notices
        )
        self._scene = SceneLink(scenario, seed, self._notices, self._news.set)
        self._policy = PolicyLink(self._notices, self._news.set)
        self._reward_maps = RewardMapLink(workers, self._notices, self._news.set)
        self._following = Following(self._policy, self._training)
        self._pushing = Pushing(self._scene, self._policy, self._notices)
        if (checkpoints / FIRST_POLICY).is_dir():
            self._policy.load(str(checkpoints / FIRST_POLICY))

    def submit(self, command: Command) -> None:
        """Enqueue a command; beyond a thousand waiting ones it is dropped."""
        try:
            self._commands.put_nowait(command)
        except queue.Full:
            return
        self._news.set()

    def wake(self) -> None:
        """End a `wait`: something has happened outside the laboratory."""
        self._news.set()

    def set_wanted_fields(self, fields: Set[str]) -> None:
        """Compute these fields (`FIELDS`) and no others from now on."""
        self._wanted = frozenset(fields) & FIELDS

    def wait(self, timeout_s: float) -> bool:
        """Wait for a command, a message of a process, or `wake`.

        Returns:
            Whether there was one; the next `tick` takes it in.
        """
        return self._news.wait(timeout_s)

    def tick(self) -> Snapshot:
        """Carry out waiting commands, hear the processes, and take a picture; never waits."""
        self._news.clear()
        for _ in range(self._commands.qsize()):
            self._obey(self._commands.get_nowait())
        self._pushing.note_finished(self._scene.update())
        rest = self._scene.rest
        self._pushing.note_answers(self._policy.update(rest, self._wanted))
        self._watch()
        self._reward_maps.update(
            rest,
            is_wanted="reward_map" in self._wanted and not self._scene.is_pushing,
            is_dragged=self._scene.is_held,
        )
        self._training.update()
        self._following.update()
        return Snapshot(
            scene=self._view.snapshot(
                self._scene.live, rest, self._pushing.last_push, self._watching.is_on
            ),
            reward_map=self._reward_maps.snapshot,
            policy=self._policy.snapshot,
            run=self._training.snapshot,
            policies=self._training.policies,
            runs=self._training.runs,
            notices=self._notices.notices,
        )

    def close(self) -> Path | None:
        """End all processes; a trainer that was started here saves a checkpoint and stops.

        A laboratory that is killed cannot ask it to: its trainer goes on, and the next laboratory
        finds the run and watches it.

        Returns:
            Directory of the run that was stopped, if any.
        """
        self._training.ask_to_stop()
        self._reward_maps.close()
        self._policy.close()
        self._scene.close()
        return self._training.close()

    @property
    def has_policy(self) -> bool:
        """Whether a policy is loaded or being loaded."""
        return self._policy.is_chosen

    @property
    def pids(self) -> dict[str, int | None]:
        """Process ids by name: ``scene``, ``policy``, ``reward_map``, ``trainer``."""
        return {
            "scene": self._scene.pid,
            "policy": self._policy.pid,
            "reward_map": self._reward_maps.pid,
            "trainer": self._training.pid,
        }

    def _obey(self, command: Command) -> None:
        try:
            self._carry_out(command)
        except SingulateError as error:
            self._notices.add(str(error))
        except Exception as error:
            name = type(command).__name__
            self._notices.add(f"{name} failed ({type(error).__name__}: {error}); nothing changed.")

    def _carry_out(self, command: Command) -> None:
        match command:
            case PushNow(push, by):
                self._pushing.push(push, by)
            case AgentPush():
                self._pushing.let_policy_push()
            case ResetScene(scenario, seed):
                check_recipe(scenario, seed)
                self._scene.send(command)
            case SetScenePaused(is_paused):
                self._scene.send(SetScenePaused(bool(is_paused)))
            case _ if isinstance(command, Undo | StepScene | ArrangeBlocks):
                self._scene.send(command)
            case SetSpeed(factor):
                self._set_speed(factor)
            case SetWatching(is_on):
                self._set_watching(is_on)
            case LoadPolicy(source):
                self._following.choose(source)
            case DismissNotice(notice_id):
                self._notices.dismiss(notice_id)
            case _:
                self._training.obey(command)

    def _set_speed(self, factor: float) -> None:
        low, high = SPEED_RANGE
        if not (is_finite_number(factor) and low <= factor <= high):
            raise InvalidValueError("speed", factor, f"{low} to {high}")
        self._scene.send(SetSpeed(float(factor)))

    def _set_watching(self, is_on: bool) -> None:
        if is_on and not self._policy.is_loaded:
            raise InvalidValueError("watching", is_on, "a loaded policy first: load or train one")
        self._watching.switch(bool(is_on))

    def _watch(self) -> None:
        live, rest = self._scene.live, self._scene.rest
        is_busy = self._scene.is_pushing or self._scene.is_held
        if live is None or rest is None or is_busy or live.is_paused:
            return
        match self._watching.next_move(rest, live.speed, time.monotonic()):
            case NextMove.PUSH:
                self._pushing.let_policy_push()
            case NextMove.NEW_SCENE:
                self._scene.send(ResetScene(rest.scene.scenario, rest.scene.seed + 1))
