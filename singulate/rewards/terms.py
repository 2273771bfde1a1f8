"""The terms of the reward: what of a push is paid for, before weighting."""

from collections.abc import Callable
from typing import NamedTuple

from singulate.geometry import Push, Workspace
from singulate.perception import Percept, Segmentation
from singulate.rewards.distance import distance_reward
from singulate.rewards.inside import inside_reward
from singulate.rewards.start import object_distance, start_reward
from singulate.rewards.success import is_success, success_reward


class Transition(NamedTuple):
    """One push and what the camera saw before and after it.

    Attributes:
        before: The scene before the push.
        push: The push.
        after: The scene after the push; `before` again where the push could not be made.
        is_inside: Whether the push starts inside an object.
        num_blocks: How many blocks the scene holds.
        goal_separation: d_goal [m].
        workspace: The workspace.
    """

    before: Percept
    push: Push
    after: Segmentation
    is_inside: bool
    num_blocks: int
    goal_separation: float
    workspace: Workspace


def _start(t: Transition) -> float:
    return start_reward(object_distance(t.before, t.push, t.workspace), t.workspace)


def _distance(t: Transition) -> float:
    return distance_reward(
        t.before.inter_object_distance_truncated(t.goal_separation),
        t.after.inter_object_distance_truncated(t.goal_separation),
    )


def _inside(t: Transition) -> float:
    return inside_reward(t.is_inside)


def _success(t: Transition) -> float:
    return success_reward(is_success(t.after, t.num_blocks, t.goal_separation))


_TERMS: dict[str, Callable[[Transition], float]] = {
    "start": _start,
    "distance": _distance,
    "inside": _inside,
    "success": _success,
}

TERMS: tuple[str, ...] = tuple(_TERMS)
"""Names of all terms, in the order of Eq. 7."""


def reward_terms(transition: Transition) -> dict[str, float]:
    """r_Start, r_Dist [m], r_Inside and r_Success of one push, unweighted, by name."""
    return {name: term(transition) for name, term in _TERMS.items()}
