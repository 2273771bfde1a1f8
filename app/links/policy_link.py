"""The laboratory's end of the policy process."""

from collections import deque
from collections.abc import Callable, Set

from app.notices import NoticeBoard
from app.processes.policy_messages import (
    ChoosePush,
    ChosenPush,
    ComputeFields,
    Fields,
    Load,
    Loaded,
    NotLoaded,
    PolicyProblem,
    Prediction,
    PredictReward,
)
from app.processes.scene_messages import RestState
from app.processes.supervised import SupervisedProcess
from app.snapshot import PolicySnapshot
from singulate.geometry import Push

Q_MAP = "q_map"
START_DENSITY = "start_density"


class PolicyLink:
    """Keeps a policy loaded and its fields up to date with the scene, as far as they are wanted.

    Args:
        notices: Where problems are told.
        on_message: Called from another thread when something has arrived.
    """

    def __init__(self, notices: NoticeBoard, on_message: Callable[[], None]) -> None:
        self._notices = notices
        self._source = ""
        self._to_send: deque[Load] = deque()
        self._wants_live = False
        self._failed = ""
        self._loaded: Loaded | None = None
        self._fields: Fields | None = None
        self._asked: tuple[str, int, frozenset[str]] | None = None
        self._is_waiting = False
        self._is_published = True
        self.is_live = False
        self.snapshot: PolicySnapshot | None = None
        self._process = SupervisedProcess(
            "The policy process",
            "app.processes.policy_process:run_policy",
            on_message=on_message,
            niceness=1,
        )

    @property
    def pid(self) -> int:
        """Process id of the policy process."""
        return self._process.pid

    @property
    def is_chosen(self) -> bool:
        """Whether there is a policy or one is being loaded."""
        return bool(self._source)

    @property
    def is_following(self) -> bool:
        """Whether the policy is of a run that is followed, and no other was asked for since."""
        is_last = self._loaded is not None and self._loaded.source == self._source
        return is_last and self._wants_live

    @property
    def is_loaded(self) -> bool:
        """Whether there is a policy to ask."""
        return self._loaded is not None

    def load(self, source: str, *, is_live: bool = False) -> None:
        """Load a checkpoint; the policy before it answers until then.

        Args:
            source: Checkpoint directory.
            is_live: Whether it is one of a run that is being followed.
        """
        if source == self._source:
            self._wants_live = is_live
            if self._loaded is not None and self._loaded.source == source:
                self._set_live(is_live)
        elif not (is_live and source == self._failed):
            self._source, self._wants_live = source, is_live
            self._to_send.append(Load(source))
            self._send_loads()

    def choose(self, rest: RestState) -> None:
        """Ask for the push that the policy would make; a lost question is told on the page."""
        if not self._process.send(ChoosePush(rest.version, rest.percept)):
            self._notices.add("The policy process did not take the question; try again soon.")

    def predict(self, push_id: int, rest: RestState, push: Push) -> None:
        """Ask for the reward that the policy expects of a push."""
        if self._loaded is not None:
            self._process.send(PredictReward(push_id, rest.percept, push))

    def update(self, rest: RestState | None, wanted: Set[str]) -> list[ChosenPush | Prediction]:
        """Take in what has arrived, ask for wanted fields, and see that the process lives."""
        answers: list[ChosenPush | Prediction] = []
        for message in self._process.receive():
            if isinstance(message, ChosenPush | Prediction):
                answers.append(message)
            else:
                self._hear(message)
        explanation = self._process.watch()
        if explanation is not None:
            self._begin_again(explanation)
        self._send_loads()
        self._ask_for_fields(rest, frozenset(wanted) & {Q_MAP, START_DENSITY})
        if not self._is_published and not self._is_waiting:
            self._publish()
        return answers

    def close(self) -> None:
        """End the process."""
        self._process.close()

    def _hear(self, message: object) -> None:
        match message:
            case Loaded():
                self._loaded = message
                self._failed = ""
                if message.source == self._source:
                    self.is_live = self._wants_live
                self._is_published = False
            case NotLoaded(source, reason, has_other):
                self._notices.add(f"{reason}. Choose another policy, or train one.")
                self._failed = source
                if not has_other:
                    self._loaded = self._fields = self.snapshot = None
                    self._asked = None
                if source == self._source:
                    self._source = self._loaded.source if self._loaded else ""
                    self._wants_live = self.is_live
            case Fields():
                self._is_waiting = False
                self._fields = message
                self._is_published = False
            case PolicyProblem(reason):
                self._is_waiting = False
                self._notices.add(reason)

    def _begin_again(self, explanation: str) -> None:
        self._notices.add(f"{explanation} It is loading the same policy again.")
        self._is_waiting = False
        self._asked = None
        known = (self._loaded.source if self._loaded else "", self._source)
        self._to_send = deque(Load(source) for source in dict.fromkeys(known) if source)

    def _send_loads(self) -> None:
        """What the process does not take, because it rests after many deaths, it gets later."""
        while self._to_send and self._process.send(self._to_send[0]):
            self._to_send.popleft()

    def _ask_for_fields(self, rest: RestState | None, wanted: frozenset[str]) -> None:
        if rest is None or self._loaded is None or not wanted or self._is_waiting:
            return
        question = (self._loaded.source, rest.version, wanted)
        if question == self._asked:
            return
        self._is_waiting = self._process.send(
            ComputeFields(
                rest.version,
                rest.percept,
                wants_q_map=Q_MAP in wanted,
                wants_start_density=START_DENSITY in wanted,
            )
        )
        if self._is_waiting:
            self._asked = question

    def _set_live(self, is_live: bool) -> None:
        if is_live != self.is_live:
            self.is_live = is_live
            self._is_published = False

    def _publish(self) -> None:
        """Show the loaded policy, with its own fields or with none."""
        self._is_published = True
        loaded, fields = self._loaded, self._fields
        if loaded is None:
            return
        if fields is not None and fields.source != loaded.source:
            fields = None
        self.snapshot = PolicySnapshot(
            label=loaded.label,
            kind=loaded.kind,
            source=loaded.source,
            num_steps=loaded.num_steps,
            has_q_map=loaded.has_q_map,
            q_map=fields.q_map if fields else None,
            start_density=fields.start_density if fields else None,
            start_modes=fields.start_modes if fields else (),
            scene_version=fields.version if fields else 0,
            is_live=self.is_live,
        )
