"""What decides an autoencoder."""

import hashlib
import json
from dataclasses import asdict, dataclass

from singulate.agents.config_fields import check_int, check_positive
from singulate.simulation import make_scenario

EVERY_FAMILY = "random-2+random-3+random-4+cluster-3+cluster-4+cluster-5"
"""Rows and clusters: whatever an agent of this project begins an episode with."""


@dataclass(frozen=True)
class AutoencoderConfig:
    """Settings of a training; the paper names the idea alone, so all of them are ours.

    Attributes:
        scenario: Where the scenes are from.
        num_scenes: Scenes to learn from; each is also seen turned and mirrored.
        num_updates: Gradient steps.
        batch_size: Maps a gradient step.
        learning_rate: Step size of Adam at the start; it falls evenly to 0.
        seed: Decides the scenes, the network and all random choices.

    Raises:
        InvalidValueError: If a value is not allowed.
    """

    scenario: str = EVERY_FAMILY
    num_scenes: int = 4_000
    num_updates: int = 5_000
    batch_size: int = 32
    learning_rate: float = 3e-3
    seed: int = 0

    def __post_init__(self) -> None:
        make_scenario(self.scenario)
        check_int("scenes", self.num_scenes, 1, 1_000_000)
        check_int("updates", self.num_updates, 1)
        check_int("batch_size", self.batch_size, 1, 100_000)
        check_positive("learning_rate", self.learning_rate, 1.0)
        check_int("seed", self.seed, 0, 2**32 - 1)

    @property
    def key(self) -> str:
        """Hash of what decides the weights."""
        content = json.dumps(asdict(self), sort_keys=True)
        return hashlib.sha256(content.encode()).hexdigest()[:16]
