"""How much a reproduction computes."""

from dataclasses import dataclass, field

from singulate.agents.autoencoder.config import AutoencoderConfig
from singulate.agents.config_fields import check_int
from singulate.exceptions import InvalidValueError
from singulate.training.config import MAX_SEED

QUICK_STEPS = 2048
"""One update of PPO (Table 1)."""


@dataclass(frozen=True)
class Plan:
    """What decides the numbers of a reproduction.

    Attributes:
        seeds: Seeds of the trainings.
        max_steps: Longest training; shorter ones, and those whose length the paper gives, keep
            theirs. None leaves all at theirs.
        is_quick: Whether `max_steps` holds for every training.
        episodes: Episodes of each evaluation.
        num_scenes: Scenes of each ceiling.
        resolution: Starts along each side of the reward maps of Fig. 2.
        evaluation_seed: Decides the unseen scenes.
        autoencoder: What agents look through that see a code.

    Raises:
        InvalidValueError: If a value is not allowed.
    """

    seeds: tuple[int, ...] = (0, 1, 2)
    max_steps: int | None = None
    is_quick: bool = False
    episodes: int = 1000
    num_scenes: int = 1000
    resolution: int = 64
    evaluation_seed: int = 7
    autoencoder: AutoencoderConfig = field(default_factory=AutoencoderConfig)

    def __post_init__(self) -> None:
        if not self.seeds:
            raise InvalidValueError("seeds", self.seeds, "at least one")
        for seed in self.seeds:
            check_int("seeds", seed, 0, MAX_SEED)
        if self.max_steps is not None:
            check_int("steps", self.max_steps, 300, 1_000_000_000)

    def steps_of(self, total_timesteps: int, is_given: bool) -> int:
        """Pushes of a training.

        Args:
            total_timesteps: Its length in full.
            is_given: Whether the paper gives it.
        """
        if self.max_steps is None or (is_given and not self.is_quick):
            return total_timesteps
        return min(total_timesteps, self.max_steps)


def quick_plan() -> Plan:
    """One seed and minutes instead of hours: shows that everything works, and proves nothing."""
    quick = AutoencoderConfig(num_scenes=200, num_updates=100)
    return Plan(
        (0,), QUICK_STEPS, True, episodes=50, num_scenes=20, resolution=16, autoencoder=quick
    )
