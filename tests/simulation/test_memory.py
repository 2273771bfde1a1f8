"""A process may look at any number of scenes."""

import numpy as np
import psutil

from singulate.simulation import Scene, make_scenario


def resident_mib() -> float:
    return psutil.Process().memory_info().rss / 2**20


def test_memory_is_flat_over_thousands_of_scenes_with_new_blocks(scene: Scene):
    rng = np.random.default_rng(0)
    scenario = make_scenario("random-3")

    def look_at(num_scenes: int) -> None:
        for _ in range(num_scenes):
            scene.place(scenario.sample(rng, scene.workspace))
            scene.photograph_blocks()

    look_at(1000)
    before = resident_mib()
    look_at(4000)
    # Without starting Bullet anew now and then, this grows by 45 MiB.
    assert resident_mib() - before < 10
