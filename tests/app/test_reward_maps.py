"""Reward maps: coarse to fine, only while wanted, cancelled when the scene changes."""

import itertools
import math
import os
import signal
import time

import numpy as np
import psutil
import pytest

from app.commands import HoldBlock, MoveBlock, PushNow, ReleaseBlock, ResetScene, SetSpeed, Undo
from singulate.geometry import Direction, Push


@pytest.fixture(scope="module")
def bench(make_bench):
    bench = make_bench(scenario="fixed-2", seed=0)
    bench.do(SetSpeed(8.0))
    return bench


def test_a_map_is_computed_only_when_wanted_then_refined_and_cancelled_on_change(bench):
    assert all(s.reward_map is None for s in bench.run(0.5))
    assert bench.laboratory.pids["reward_map"] is None
    bench.laboratory.set_wanted_fields({"reward_map"})
    first = bench.snapshot.scene.version
    coarse = bench.until(lambda s: s.reward_map is not None).reward_map
    assert coarse.values.shape == (4, coarse.resolution, coarse.resolution)
    assert coarse.values.dtype == np.float32 and np.isfinite(coarse.values).all()
    assert coarse.resolution < 64 and coarse.scene_version == first
    partial = bench.until(lambda s: 0.0 < s.reward_map.progress < 1.0).reward_map
    assert partial.resolution == 64

    bench.do(PushNow(Push.cardinal((0.0, -0.35), Direction.UP, 0.5)))
    pushing = [s for s in [*bench.run(0.5)] if s.scene.is_pushing]
    assert len({s.reward_map.progress for s in pushing[5:]}) <= 1
    bench.until(lambda s: s.reward_map.scene_version > first)
    assert bench.snapshot.reward_map.scene_version == bench.snapshot.scene.version
    progress = []
    bench.until(lambda s: progress.append(s.reward_map.progress) or progress[-1] == 1.0, 120)
    assert progress == sorted(progress)
    assert bench.snapshot.reward_map.values.max() > 300.0


def test_a_finished_map_is_remembered(bench):
    finished = bench.until(lambda s: s.reward_map.progress == 1.0, 120).reward_map
    poses = bench.snapshot.scene.poses
    version = bench.snapshot.scene.version
    bench.do(PushNow(Push.cardinal((0.0, 0.6), Direction.DOWN, 0.5)))
    bench.until(lambda s: s.scene.version > version)
    bench.do(Undo())
    bench.until(lambda s: s.scene.poses == poses and s.scene.version > version + 1)
    again = bench.tick().reward_map
    assert again.scene_version == bench.snapshot.scene.version and again.progress == 1.0
    assert np.array_equal(again.values, finished.values)


def test_coarse_maps_follow_a_dragged_block_and_the_finest_its_last_place(bench):
    bench.do(HoldBlock(1, 0))
    mapped, give_up = set(), time.monotonic() + 60.0
    for step in itertools.count():  # round and round, without ever holding still
        bench.do(MoveBlock(1, (-0.5 + 0.3 * math.cos(step / 20), 0.3 + 0.3 * math.sin(step / 20))))
        maps = [snapshot.reward_map for snapshot in bench.run(0.03)]
        mapped |= {each.scene_version for each in maps if each.resolution == 8}
        if len(mapped) >= 3:
            break
        assert time.monotonic() < give_up, "no coarse maps while the block moves"
    bench.do(MoveBlock(1, (-0.8, 0.6)), ReleaseBlock(1))
    bench.until(lambda s: s.reward_map.progress == 1.0 and s.scene.held_block is None, 120)
    assert bench.snapshot.reward_map.scene_version == bench.snapshot.scene.version
    assert bench.snapshot.scene.poses[0].position[:2] == pytest.approx((-0.8, 0.6))


def test_nothing_is_computed_for_nobody(bench):
    bench.laboratory.set_wanted_fields(set())
    bench.do(ResetScene("random-2", 3))
    bench.until(lambda s: s.scene.seed == 3)
    before = bench.snapshot.reward_map
    assert all(s.reward_map is before for s in bench.run(0.5))


def test_a_killed_process_begins_again_and_takes_its_workers_along(bench):
    bench.do(ResetScene("random-3", 4))
    bench.until(lambda s: s.scene.seed == 4)
    bench.laboratory.set_wanted_fields({"reward_map"})
    version = bench.snapshot.scene.version
    bench.until(lambda s: s.reward_map.scene_version == version)
    pid = bench.laboratory.pids["reward_map"]
    process = psutil.Process(pid)
    workers = process.children(recursive=True)
    own = process.nice()
    assert sorted(worker.nice() for worker in workers) == [own, min(own + 15, 19)]
    os.kill(pid, signal.SIGKILL)
    bench.until(lambda s: any("reward-map process was killed" in text for text in bench.texts))
    assert bench.laboratory.pids["reward_map"] != pid
    _, alive = psutil.wait_procs(workers, timeout=5.0)
    assert not alive
    bench.until(lambda s: s.reward_map.progress > 0.0)
