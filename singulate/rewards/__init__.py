"""What a push is worth: pure functions of what the camera saw before and after it."""

from singulate.rewards.composite import RewardFunction
from singulate.rewards.distance import distance_reward
from singulate.rewards.inside import inside_reward
from singulate.rewards.presets import REWARDS, make_reward
from singulate.rewards.start import (
    GOAL_DISTANCE,
    StartConstants,
    object_distance,
    start_constants,
    start_reward,
)
from singulate.rewards.success import is_success, success_reward
from singulate.rewards.terms import TERMS, Transition, reward_terms

__all__ = [
    "GOAL_DISTANCE",
    "REWARDS",
    "TERMS",
    "RewardFunction",
    "StartConstants",
    "Transition",
    "distance_reward",
    "inside_reward",
    "is_success",
    "make_reward",
    "object_distance",
    "reward_terms",
    "start_constants",
    "start_reward",
    "success_reward",
]
