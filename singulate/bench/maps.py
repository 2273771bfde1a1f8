"""Reward maps against the clock."""

import time

import numpy as np

from singulate.engine import Engine
from singulate.geometry import Poses, Workspace, standing_pose
from singulate.rewardmap import RewardMapRequest, refine_levels
from singulate.simulation import make_scenario


def make_poses(scenario: str, seed: int) -> Poses:
    """The blocks that the environment puts up for this seed."""
    layout = make_scenario(scenario).sample(np.random.default_rng(seed), Workspace())
    return tuple(standing_pose(block) for block in layout)


def seconds_to_levels(engine: Engine, poses: Poses, resolution: int) -> dict[int, float]:
    """Seconds until each level of a map is complete, by resolution."""
    began = time.perf_counter()
    return {
        reward_map.resolution: time.perf_counter() - began
        for reward_map in refine_levels(RewardMapRequest(poses, resolution), engine)
    }
