"""A click sets the pusher in motion at once, while everything else keeps the cores busy."""

import statistics
import time

import pytest

from app.commands import PushNow, ResetScene, StartTraining, Undo
from singulate.geometry import Direction, Push

PERIOD_S = 1 / 30


@pytest.mark.slow
def test_a_push_starts_within_100_ms_beside_a_trainer_and_reward_maps(make_bench):
    bench = make_bench(scenario="random-8", seed=0, num_workers=2)
    bench.do(StartTraining("dqn", "random-2", 1_000_000, 0, {"checkpoint_every": 100_000}))
    bench.until(lambda s: s.run is not None and s.run.num_steps > 0)
    bench.laboratory.set_wanted_fields({"reward_map"})
    bench.until(lambda s: s.reward_map is not None)
    latencies = []
    for seed in range(20):
        bench.do(ResetScene("random-8", 100 + seed))
        bench.until(lambda s, n=seed: s.scene.seed == 100 + n)
        bench.run(0.2)  # the reward map of the new scene is under way
        count = bench.snapshot.scene.motion_count
        began = time.perf_counter()
        bench.do(PushNow(Push.cardinal((-0.9, 0.9), Direction.RIGHT, 0.5)))
        while bench.snapshot.scene.motion_count == count:
            bench.snapshot = bench.laboratory.tick()
            bench.laboratory.wait(PERIOD_S)
        latencies.append(time.perf_counter() - began)
        bench.do(Undo())
        bench.until(lambda s: not s.scene.is_pushing)
    assert statistics.median(latencies) < 0.1, latencies
