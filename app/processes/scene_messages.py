"""What the scene process and the laboratory tell each other (plain values only).

The commands `ResetScene`, `Undo`, `ArrangeBlocks`, `SetScenePaused`, `StepScene` and `SetSpeed`
are passed on as they are.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from app.snapshot import PushReport
from singulate.geometry import Poses, Push
from singulate.perception.percept import Percept


@dataclass(frozen=True)
class SavedScene:
    """A state at rest that can be returned to.

    Attributes:
        scenario: Recipe that the scene came from.
        seed: Seed of that recipe.
        num_blocks: Blocks that it started with, fallen ones included.
        poses: Where they are.
        num_pushes: Pushes since the scene was put up, or since blocks were last moved by hand.
        is_rearranged: Whether blocks were moved, added or removed by hand.
    """

    scenario: str
    seed: int
    num_blocks: int
    poses: Poses
    num_pushes: int
    is_rearranged: bool = False


@dataclass(frozen=True)
class SceneStart:
    """How a scene process begins: fresh from a recipe, or where a dead one has left off.

    Attributes:
        scenario: Recipe of a fresh scene.
        seed: Seed of a fresh scene.
        saved: The scene to continue with; replaces the recipe.
        history: States that undo returns to, oldest first.
        version: Number of the first state at rest.
        speed: Playback speed.
        is_paused: Whether motion is frozen.
    """

    scenario: str
    seed: int
    saved: SavedScene | None = None
    history: tuple[SavedScene, ...] = ()
    version: int = 1
    speed: float = 1.0
    is_paused: bool = False


@dataclass(frozen=True)
class StartPush:
    """Push now; `push_id` comes back with the report."""

    push: Push
    by: str
    push_id: int


@dataclass(frozen=True)
class LiveState:
    """What moves: sent at 30 Hz or more during a push, and when anything else here changes."""

    poses: Poses
    pusher: tuple[float, float, float, float] | None
    active_push: Push | None
    pushed_by: str
    is_paused: bool
    speed: float
    motion_count: int
    held_block: int | None = None
    held_by: str = ""


@dataclass(frozen=True)
class RestState:
    """The scene at rest and what the camera sees of it."""

    version: int
    scene: SavedScene
    history: tuple[SavedScene, ...]
    max_pushes: int
    percept: Percept
    rgb: npt.NDArray[np.uint8]
    is_success: bool
    has_fallen: bool


@dataclass(frozen=True)
class FinishedPush:
    """A push that has been executed; its report still lacks the prediction."""

    push_id: int
    report: PushReport


@dataclass(frozen=True)
class SceneUpdate:
    """One message of the scene process; the parts belong to the same moment."""

    live: LiveState
    rest: RestState | None = None
    finished: FinishedPush | None = None


@dataclass(frozen=True)
class Refused:
    """A command could not be carried out: why, in one line."""

    reason: str
