"""The laboratory's end of the reward-map process."""

import time
from collections import OrderedDict
from collections.abc import Callable

from app.links.giving_way import GivingWay
from app.notices import NoticeBoard
from app.processes.reward_map_messages import (
    CancelRewardMap,
    ComputeRewardMap,
    RewardMapProblem,
    RewardMapUpdate,
)
from app.processes.scene_messages import RestState
from app.processes.supervised import SupervisedProcess
from app.snapshot import RewardMapSnapshot
from singulate.geometry import Poses

_NICENESS = 1
_MAX_REMEMBERED = 32


class RewardMapLink:
    """Has the reward of every push computed while somebody looks at it and the scene is at rest.

    The process is started when a map is wanted for the first time. Finished maps of recent scenes
    are remembered, so that undoing a push shows the map at once. While a block is dragged, scenes
    follow each other faster than maps: coarsest levels are completed, all that have not just begun
    (`GivingWay`), so that the field on the table follows, and the finer ones are left to the scene
    that stays.

    Args:
        num_workers: Processes that push in parallel.
        notices: Where problems are told.
        on_message: Called from another thread when something has arrived.
    """

    def __init__(
        self, num_workers: int, notices: NoticeBoard, on_message: Callable[[], None]
    ) -> None:
        self._num_workers = num_workers
        self._notices = notices
        self._on_message = on_message
        self._process: SupervisedProcess | None = None
        self._computing: RestState | None = None
        self._has_coarse = False
        self._giving_way = GivingWay()
        self._failed_version = 0
        self._remembered: OrderedDict[Poses, RewardMapUpdate] = OrderedDict()
        self.snapshot: RewardMapSnapshot | None = None

    @property
    def pid(self) -> int | None:
        """Process id of the reward-map process, once it has been started."""
        return self._process.pid if self._process else None

    def update(self, rest: RestState | None, *, is_wanted: bool, is_dragged: bool = False) -> None:
        """Take in what has arrived; start, replace or cancel the map under way.

        Args:
            rest: The scene.
            is_wanted: Whether somebody looks at the map, and no push is under way.
            is_dragged: Whether somebody has a block in the hand.
        """
        self._listen()
        target = rest if is_wanted else None
        computing = self._computing
        if computing is not None and (target is None or target.version != computing.version):
            is_passing = target is not None and is_dragged and not self._has_coarse
            if not is_passing or self._giving_way.give_way(time.monotonic()):
                self._cancel()
        if target is not None and self._computing is None and not self._is_settled(target):
            self._begin(target)

    def close(self) -> None:
        """End the process and its workers."""
        if self._process is not None:
            self._process.close()

    def _listen(self) -> None:
        if self._process is None:
            return
        for message in self._process.receive():
            self._hear(message)
        explanation = self._process.watch()
        if explanation is not None:
            self._notices.add(f"{explanation} The reward map is being computed again.")
            self._computing = None

    def _hear(self, message: object) -> None:
        computing = self._computing
        match message:
            case RewardMapUpdate() if computing and message.version == computing.version:
                self._publish(message, computing.version)
                if not self._has_coarse:
                    self._has_coarse = True
                    self._giving_way.finish(time.monotonic())
                if message.progress >= 1.0:
                    self._remember(computing.scene.poses, message)
                    self._computing = None
            case RewardMapProblem(version, reason):
                self._notices.add(f"The reward map could not be computed: {reason}")
                self._failed_version = version
                self._computing = None

    def _is_settled(self, rest: RestState) -> bool:
        """Whether nothing is left to do for a scene; shows a remembered map."""
        shown = self.snapshot
        if shown is not None and shown.scene_version == rest.version and shown.progress >= 1.0:
            return True
        remembered = self._remembered.get(rest.scene.poses)
        if remembered is not None:
            self._publish(remembered, rest.version)
        return remembered is not None or self._failed_version == rest.version

    def _begin(self, rest: RestState) -> None:
        if self._process is None:
            self._process = SupervisedProcess(
                "The reward-map process",
                "app.processes.reward_map_process:run_reward_maps",
                arguments=lambda: (self._num_workers,),
                niceness=_NICENESS,
                on_message=self._on_message,
            )
        question = ComputeRewardMap(rest.version, rest.scene.poses)
        if self._process.send(question):
            self._computing = rest
            self._has_coarse = False
            self._giving_way.begin(time.monotonic())

    def _cancel(self) -> None:
        self._computing = None
        if self._process is not None:
            self._process.send(CancelRewardMap())

    def _remember(self, poses: Poses, update: RewardMapUpdate) -> None:
        self._remembered[poses] = update
        while len(self._remembered) > _MAX_REMEMBERED:
            self._remembered.popitem(last=False)

    def _publish(self, update: RewardMapUpdate, version: int) -> None:
        self.snapshot = RewardMapSnapshot(
            update.values, update.resolution, update.progress, version
        )
