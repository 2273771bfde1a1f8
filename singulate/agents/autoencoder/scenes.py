"""Distance maps of random scenes, without a single push."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from singulate.envs.push_task import PushTask
from singulate.simulation import make_scenario

Maps = npt.NDArray[np.float32]


def draw_maps(
    scenario: str,
    num_scenes: int,
    rng: np.random.Generator,
    on_progress: Callable[[int], None] = lambda done: None,
) -> Maps:
    """Put up scenes and look at each.

    Args:
        scenario: Where they are from.
        num_scenes: How many.
        rng: Decides them.
        on_progress: Called with the number of scenes seen so far.

    Returns:
        float32 (num_scenes, H, W) [px], -1 inside objects.

    Raises:
        InvalidValueError: If there is no such scenario.
    """
    sampler, task = make_scenario(scenario), PushTask()
    size = task.workspace.image_size
    maps = np.empty((num_scenes, size, size), np.float32)
    try:
        for index in range(num_scenes):
            task.place(sampler.sample(rng, task.workspace))
            maps[index] = task.percept.distance_map
            on_progress(index + 1)
    finally:
        task.close()
    return maps
