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
