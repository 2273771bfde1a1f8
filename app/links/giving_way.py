"""A coarse map that has hardly begun gives way to the next scene of a drag."""

_FIRST_GUESS_S = 0.1
_MEMORY = 0.7


class GivingWay:
    """Decides which of two scenes of a drag has its coarse map finished.

    Scenes of a drag follow each other as fast as coarse maps. If each map were finished, the scene
    in which the drag pauses would wait for up to a whole map of another; if none were, the field
    would not follow while the block moves on. So a map gives way in its first half, as long as
    maps usually take, and the one after it does not.
    """

    def __init__(self) -> None:
        self._usual_s = _FIRST_GUESS_S
        self._began_s = 0.0
        self._is_owed = False

    def begin(self, now_s: float) -> None:
        """A map is begun at some time of any steady clock [s]."""
        self._began_s = now_s

    def finish(self, now_s: float) -> None:
        """The coarse map has come."""
        taken_s = now_s - self._began_s
        self._usual_s = _MEMORY * self._usual_s + (1.0 - _MEMORY) * taken_s
        self._is_owed = False

    def give_way(self, now_s: float) -> bool:
        """Whether the map under way is given up for a scene that has come at this time."""
        gives_way = not self._is_owed and now_s - self._began_s < self._usual_s / 2
        self._is_owed |= gives_way
        return gives_way
