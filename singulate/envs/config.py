"""What defines an environment, checked on the way in."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Self

from singulate.envs.actions import ACTION_ENCODINGS
from singulate.envs.observations import OBSERVATIONS
from singulate.exceptions import InvalidValueError
from singulate.finite import is_finite_number
from singulate.rewards import make_reward
from singulate.simulation import make_scenario

MAX_PUSHES_LIMIT = 1000


@dataclass(frozen=True)
class EnvConfig:
    """Settings of ``singulate/Push-v0``.

    Attributes:
        scenario: Family and number of blocks, such as ``random-2``.
        observation: ``distance_map`` or ``mask`` (paper, sections 3.2.1 and 5).
        action: ``grid``, ``point`` or ``start_end`` (sections 5.4, 3.2.2 and 5).
        reward: ``paper``, ``separation``, ``start`` or ``start_then_separation``.
        max_pushes: Pushes an episode may take; None leaves it to the scenario.
        goal_separation: Every pair of blocks has to be this far apart, d_goal of Eq. 2 [m].
        exact: Whether to simulate every step of every push, also what cannot move a block.

    Raises:
        InvalidValueError: If a value is not allowed.
    """

    scenario: str = "random-2"
    observation: str = "distance_map"
    action: str = "point"
    reward: str = "paper"
    max_pushes: int | None = None
    goal_separation: float = 0.1
    exact: bool = False

    def __post_init__(self) -> None:
        make_scenario(self.scenario)
        make_reward(self.reward)
        _check_choice("observation", self.observation, OBSERVATIONS)
        _check_choice("action", self.action, ACTION_ENCODINGS)
        pushes = self.max_pushes
        is_count = isinstance(pushes, int) and not isinstance(pushes, bool)
        if pushes is not None and not (is_count and 1 <= pushes <= MAX_PUSHES_LIMIT):
            raise InvalidValueError(
                "max_pushes", pushes, f"1 to {MAX_PUSHES_LIMIT}; left out, the scenario's own"
            )
        goal = self.goal_separation
        if not (is_finite_number(goal) and 0.0 < goal <= 1.0):
            raise InvalidValueError("goal_separation", goal, "more than 0, at most 1 [m]")
        if not isinstance(self.exact, bool):
            raise InvalidValueError("exact", self.exact, "true or false")

    @cached_property
    def push_limit(self) -> int:
        """Pushes an episode may take, with the scenario's default filled in."""
        return self.max_pushes or make_scenario(self.scenario).default_max_pushes

    def to_dict(self) -> dict[str, object]:
        """Plain values, for JSON."""
        return dataclasses.asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, object]) -> Self:
        """The inverse of `to_dict`.

        Raises:
            InvalidValueError: If a key is unknown or a value is not allowed.
        """
        known = [field.name for field in dataclasses.fields(cls)]
        for key in values:
            if key not in known:
                raise InvalidValueError("environment setting", key, ", ".join(known))
        return cls(**values)  # type: ignore[arg-type]


def _check_choice(key: str, value: object, choices: Mapping[str, object]) -> None:
    if not isinstance(value, str) or value not in choices:
        raise InvalidValueError(key, value, ", ".join(choices))
