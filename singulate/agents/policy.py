"""What the page, the evaluation and notebooks may ask of any agent."""

from typing import Protocol, runtime_checkable

import numpy as np
import numpy.typing as npt

from singulate.geometry import Poses, Push

FloatMap = npt.NDArray[np.float32]


@runtime_checkable
class Policy(Protocol):
    """Chooses pushes.

    Attributes:
        kind: Name in the agent registry, or ``random``.
        observation: Name of the observation that it expects.
        is_random: Whether it acts by drawing from a distribution. Whoever wants to see it act as it
            was trained to then passes a generator to `act`.
    """

    kind: str
    observation: str
    is_random: bool

    def act(self, observation: FloatMap, rng: np.random.Generator | None = None) -> Push:
        """Choose a push for an observation, float32 (H, W).

        Args:
            observation: What the environment's observation encoding gave.
            rng: Draw with this generator, from the density or now and then another push than the
                best one; greedy without it.
        """
        ...

    def predict_value(self, observation: FloatMap, push: Push) -> float | None:
        """Total reward that the agent expects, in reward units; None where it cannot tell."""
        ...


@runtime_checkable
class HasQMap(Protocol):
    """A policy with a value for every discrete push."""

    def q_map(self, observation: FloatMap) -> FloatMap:
        """Expected total reward, float32 (4, H, W): up, right, down, left; cells of the grid."""
        ...


@runtime_checkable
class HasStartDensity(Protocol):
    """A policy with a distribution of start positions."""

    def start_density(self, observation: FloatMap) -> FloatMap:
        """Probability that a push starts in each image cell, float32 (H, W), summing to 1."""
        ...


@runtime_checkable
class SeesPoses(Protocol):
    """No policy but a yardstick: it chooses by the true poses, which no agent may see."""

    def act_on(self, poses: Poses, goal_separation: float) -> Push:
        """Choose a push for blocks at rest; d_goal of Eq. 2 [m] decides what success is."""
        ...

    def close(self) -> None:
        """Let go of what it needs for that; it may be asked again."""
        ...
