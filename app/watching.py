"""The loaded policy pushes again and again, scene after scene."""

from enum import Enum

from app.processes.scene_messages import RestState

_PAUSE_S = 0.6
"""Time to look at a scene between two pushes, at playback speed 1."""
_RETRY_S = 5.0
"""An answer that has not led to anything after this long got lost with a dead process."""


class NextMove(Enum):
    """What comes next while watching."""

    PUSH = "push"
    NEW_SCENE = "new scene"


class Watching:
    """Decides what comes next: a push, or, when the episode is over, a new scene."""

    def __init__(self) -> None:
        self.is_on = False
        self._seen_version = 0
        self._since_s = 0.0
        self._acted_on = 0
        self._acted_s = 0.0

    def switch(self, is_on: bool) -> None:
        """Begin or end; the scene on the table is where it begins."""
        self.is_on = is_on
        self._acted_on = 0

    def next_move(self, rest: RestState, speed: float, now_s: float) -> NextMove | None:
        """What to do with a scene at rest, on which no push is under way.

        Args:
            rest: The scene.
            speed: Playback speed.
            now_s: Time on any steady clock [s].
        """
        if rest.version != self._seen_version:
            self._seen_version, self._since_s = rest.version, now_s
        is_early = now_s - self._since_s < _PAUSE_S / speed
        has_acted = self._acted_on == rest.version and now_s - self._acted_s < _RETRY_S
        if not self.is_on or is_early or has_acted:
            return None
        self._acted_on, self._acted_s = rest.version, now_s
        return NextMove.NEW_SCENE if is_over(rest) else NextMove.PUSH


def is_over(rest: RestState) -> bool:
    """Whether an episode ends here: success, a block off the table, or no pushes left."""
    return rest.is_success or rest.has_fallen or rest.scene.num_pushes >= rest.max_pushes
