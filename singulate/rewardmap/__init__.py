"""True reward of every push on a scene, by real simulated pushes, coarse first."""

from singulate.rewardmap.algorithm import Cancelled, LevelAlgorithm
from singulate.rewardmap.refinement import (
    RewardMapCancelledError,
    compute_reward_map,
    refine_levels,
    refinement_levels,
)
from singulate.rewardmap.request import RewardMapRequest
from singulate.rewardmap.reward_map import RewardMap, load_reward_map

__all__ = [
    "Cancelled",
    "LevelAlgorithm",
    "RewardMap",
    "RewardMapCancelledError",
    "RewardMapRequest",
    "compute_reward_map",
    "load_reward_map",
    "refine_levels",
    "refinement_levels",
]
