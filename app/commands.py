"""What a person can ask for: callbacks of the page only enqueue these."""

from dataclasses import dataclass, field

from singulate.geometry import Push


@dataclass(frozen=True)
class ResetScene:
    """Put up the scene that a scenario and a seed decide."""

    scenario: str
    seed: int


@dataclass(frozen=True)
class PushNow:
    """Execute a push that a person aimed; ignored while another push is under way."""

    push: Push
    by: str = "you"


@dataclass(frozen=True)
class AgentPush:
    """Let the loaded policy choose and execute one push."""


@dataclass(frozen=True)
class SetWatching:
    """Let the loaded policy push again and again, on new scenes, until switched off."""

    is_on: bool


@dataclass(frozen=True)
class Undo:
    """Return to the state before the last push or move."""


@dataclass(frozen=True)
class HoldBlock:
    """Take hold of a block; ignored while a push is under way.

    Attributes:
        drag: Number of the drag; all moves of one drag are undone together.
        index: Which block.
        by: Who takes hold of it.
    """

    drag: int
    index: int
    by: str = "you"


@dataclass(frozen=True)
class MoveBlock:
    """Bring the block that a drag holds as near to a place as the other blocks allow.

    Attributes:
        drag: Number of the drag; ignored where it holds nothing, or no longer.
        place: Of the block's centre (x, y) [m]; None leaves it where it is.
        yaw: Its turn about the vertical [rad]; None leaves it as it is.
    """

    drag: int
    place: tuple[float, float] | None = None
    yaw: float | None = None


@dataclass(frozen=True)
class ReleaseBlock:
    """Let go of the block that a drag holds."""

    drag: int


@dataclass(frozen=True)
class TurnBlock:
    """Turn a block by an angle [rad], counter-clockwise."""

    index: int
    angle: float


@dataclass(frozen=True)
class AddBlock:
    """Put another block on a free place."""


@dataclass(frozen=True)
class RemoveBlock:
    """Take a block off the table."""

    index: int


ArrangeBlocks = HoldBlock | MoveBlock | ReleaseBlock | TurnBlock | AddBlock | RemoveBlock
"""What changes the blocks by hand; ignored while a push is under way."""


@dataclass(frozen=True)
class SetScenePaused:
    """Freeze or release the motion of the scene."""

    is_paused: bool


@dataclass(frozen=True)
class StepScene:
    """Advance a frozen push by one simulation step."""


@dataclass(frozen=True)
class SetSpeed:
    """Playback speed of pushes; 1 is real time."""

    factor: float


@dataclass(frozen=True)
class LoadPolicy:
    """Use a checkpoint directory, or the newest checkpoint of the watched run (``"run"``)."""

    source: str


@dataclass(frozen=True)
class StartTraining:
    """Start a new run in the background and watch it."""

    agent: str
    scenario: str
    total_timesteps: int
    seed: int
    options: dict[str, object] = field(default_factory=dict)


@dataclass(frozen=True)
class PauseTraining:
    """Pause at the trainer's next safe point."""


@dataclass(frozen=True)
class ResumeTraining:
    """Continue a paused run, or restart a stopped or dead one from its last checkpoint."""


@dataclass(frozen=True)
class StopTraining:
    """Save a checkpoint and end the run after its current rollout."""


@dataclass(frozen=True)
class SaveCheckpoint:
    """Save a checkpoint at the trainer's next safe point."""


@dataclass(frozen=True)
class WatchRun:
    """Watch another run directory."""

    run_dir: str


@dataclass(frozen=True)
class DismissNotice:
    """Take an error message off the page."""

    notice_id: int


Command = (
    ResetScene
    | PushNow
    | AgentPush
    | SetWatching
    | Undo
    | ArrangeBlocks
    | SetScenePaused
    | StepScene
    | SetSpeed
    | LoadPolicy
    | StartTraining
    | PauseTraining
    | ResumeTraining
    | StopTraining
    | SaveCheckpoint
    | WatchRun
    | DismissNotice
)
