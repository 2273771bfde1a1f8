"""A training's links to the world."""

from collections.abc import Callable
from dataclasses import dataclass

from singulate.runs import Heartbeat
from singulate.training.controls import Controls
from singulate.training.telemetry import Telemetry


@dataclass(frozen=True)
class Progress:
    """How far a training is, for whoever waits for it.

    Attributes:
        num_steps: Pushes done.
        total_steps: Pushes asked for.
        pushes_per_second: Current speed.
        eta_s: Time left [s], None while unknown.
        num_episodes: The last episodes that this process has seen, at most a thousand.
        success_rate: Share of successes among them.
        mean_reward: Their mean reward.
    """

    num_steps: int
    total_steps: int
    pushes_per_second: float
    eta_s: float | None
    num_episodes: int
    success_rate: float
    mean_reward: float


@dataclass(frozen=True)
class Links:
    """A training's links to the world.

    Attributes:
        telemetry: Where pushes and metrics go.
        heartbeat: Where the state is shown.
        controls: What people want.
        on_progress: Called after every push.
        on_trouble: Called when the training waits because something cannot be written, with the
            reason; it may raise, which ends the training.
    """

    telemetry: Telemetry
    heartbeat: Heartbeat
    controls: Controls
    on_progress: Callable[[Progress], None] | None = None
    on_trouble: Callable[[str], None] | None = None
