"""Pushes from the wish to the report: predicted by the policy, executed by the scene."""

from collections import OrderedDict
from collections.abc import Iterable
from dataclasses import replace

from app.links.policy_link import PolicyLink
from app.links.scene_link import SceneLink
from app.notices import NoticeBoard
from app.processes.policy_messages import ChosenPush, Prediction
from app.processes.scene_messages import FinishedPush, StartPush
from app.snapshot import PushReport
from singulate.exceptions import InvalidValueError
from singulate.geometry import Push

_MAX_PREDICTIONS = 16


class Pushing:
    """Starts pushes at once and asks for their predictions beside.

    Args:
        scene: Executes pushes.
        policy: Chooses them, and predicts what they bring.
        notices: Where problems are told.
    """

    def __init__(self, scene: SceneLink, policy: PolicyLink, notices: NoticeBoard) -> None:
        self._scene = scene
        self._policy = policy
        self._notices = notices
        self._last_id = 0
        self._reported_id = 0
        self._predictions: OrderedDict[int, float | None] = OrderedDict()
        self.last_push: PushReport | None = None

    def push(self, push: Push, by: str) -> None:
        """Push now, unless another push is under way.

        Raises:
            InvalidValueError: If this is no push.
        """
        if not isinstance(push, Push):
            raise InvalidValueError("push", push, "a Push")
        rest = self._scene.rest
        if rest is None or self._scene.is_pushing:
            return
        self._last_id += 1
        self._scene.send(StartPush(push, str(by), self._last_id))
        self._policy.predict(self._last_id, rest, push)

    def let_policy_push(self) -> None:
        """Ask the policy for a push; it is executed when the answer comes.

        Raises:
            InvalidValueError: If no policy is loaded.
        """
        rest = self._scene.rest
        if rest is None or self._scene.is_pushing:
            return
        if not self._policy.is_loaded:
            raise InvalidValueError("agent push", "no policy", "a loaded policy: load or train one")
        self._policy.choose(rest)

    def note_answers(self, answers: Iterable[ChosenPush | Prediction]) -> None:
        """Execute what the policy chose for this very scene; keep what it predicted."""
        for answer in answers:
            if isinstance(answer, Prediction):
                self._note_prediction(answer)
            elif self._scene.rest is not None and answer.version == self._scene.rest.version:
                self.push(answer.push, "agent")

    def note_finished(self, finished: Iterable[FinishedPush]) -> None:
        """Report pushes that have come to rest."""
        for push in finished:
            self._reported_id = push.push_id
            self.last_push = replace(push.report, predicted=self._predictions.get(push.push_id))

    def _note_prediction(self, prediction: Prediction) -> None:
        self._predictions[prediction.push_id] = prediction.reward
        while len(self._predictions) > _MAX_PREDICTIONS:
            self._predictions.popitem(last=False)
        if self.last_push is not None and prediction.push_id == self._reported_id:
            self.last_push = replace(self.last_push, predicted=prediction.reward)
