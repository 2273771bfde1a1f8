"""The table: pushes, playback, undo, and what becomes of it when its process dies."""

import math
import os
import signal
import statistics
import time

import numpy as np
import pytest

from app.commands import PushNow, ResetScene, SetScenePaused, SetSpeed, StepScene, Undo
from app.processes.scene_messages import SceneStart, StartPush
from app.processes.supervised import SupervisedProcess
from singulate.geometry import Direction, Push
from singulate.perception import distance_map


@pytest.fixture(scope="module")
def bench(make_bench):
    return make_bench(scenario="fixed-2", seed=0)


@pytest.fixture(autouse=True)
def fresh_scene(bench):
    version = bench.snapshot.scene.version
    bench.do(SetScenePaused(False), SetSpeed(8.0), ResetScene("fixed-2", 0))
    bench.until(lambda s: s.scene.version > version and s.scene.speed == 8.0)


def into_the_row():
    return Push.cardinal((0.0, -0.35), Direction.UP, 0.5)


def push_and_rest(bench, push):
    version = bench.snapshot.scene.version
    bench.do(PushNow(push))
    return bench.until(lambda s: s.scene.version > version and not s.scene.is_pushing).scene


def test_a_scenario_and_a_seed_decide_the_scene(bench):
    bench.do(ResetScene("random-3", 5))
    first = bench.until(lambda s: s.scene.scenario == "random-3").scene
    bench.do(ResetScene("random-3", 6))
    other = bench.until(lambda s: s.scene.seed == 6).scene
    bench.do(ResetScene("random-3", 5))
    again = bench.until(lambda s: s.scene.seed == 5).scene
    assert first.poses == again.poses != other.poses
    assert first.num_blocks == len(first.poses) == 3
    assert first.version < other.version < again.version


def test_the_pictures_show_the_scene_at_rest(bench):
    before = bench.snapshot.scene
    assert before.rgb.shape == (64, 64, 3) and before.rgb.dtype == np.uint8
    assert np.array_equal(before.distance_map, distance_map(before.mask))
    assert before.num_segments == 1 and not before.is_success
    after = push_and_rest(bench, into_the_row())
    assert after.version == before.version + 1
    assert not np.array_equal(after.mask, before.mask)


def test_a_push_moves_blocks_and_is_reported(bench):
    before = bench.snapshot.scene
    after = push_and_rest(bench, into_the_row())
    moved = [
        math.dist(a.position, b.position) for a, b in zip(before.poses, after.poses, strict=True)
    ]
    assert max(moved) > 0.05
    report = after.last_push
    assert report.push == into_the_row() and report.by == "you"
    assert report.predicted is None
    assert set(report.weighted_terms) == {"start", "distance", "inside", "success"}
    assert report.reward == pytest.approx(sum(report.weighted_terms.values()))
    assert report.num_segments == (1, after.num_segments)
    assert report.is_success == (report.outcome == "success") == after.is_success
    assert report.label_images[0].shape == report.label_images[1].shape == (64, 64)


def test_the_pusher_is_seen_on_its_way(bench):
    bench.do(SetSpeed(1.0))
    push = Push.cardinal((-0.6, 0.6), Direction.RIGHT, 0.5)
    bench.do(PushNow(push, by="Ada"))
    bench.until(lambda s: s.scene.is_pushing)
    assert bench.snapshot.scene.active_push == push
    assert bench.snapshot.scene.pushed_by == "Ada"
    seen = []
    bench.until(lambda s: seen.append(s.scene.pusher) or not s.scene.is_pushing)
    xs = [pusher[0] for pusher in seen if pusher is not None and pusher[2] < 1.0]
    assert xs == sorted(xs) and xs[0] < -0.4 and xs[-1] == pytest.approx(-0.1, abs=0.02)
    assert bench.snapshot.scene.pusher is None
    assert bench.snapshot.scene.last_push.outcome == "empty"


def test_a_start_on_a_block_is_inside_and_moves_nothing(bench):
    before = bench.snapshot.scene
    after = push_and_rest(bench, Push.cardinal((0.1, 0.0), Direction.UP, 0.5))
    assert after.last_push.outcome == "inside" and after.poses == before.poses


def test_a_push_is_ignored_while_another_is_under_way(bench):
    version = bench.snapshot.scene.version
    push = into_the_row()
    bench.do(PushNow(push), PushNow(Push.cardinal((0.5, 0.5), Direction.LEFT, 0.5)))
    bench.until(lambda s: s.scene.version > version and not s.scene.is_pushing)
    bench.run(0.3)
    assert bench.snapshot.scene.version == version + 1
    assert bench.snapshot.scene.last_push.push == push


def test_undo_returns_the_exact_poses(bench):
    first = bench.snapshot.scene
    assert not first.can_undo
    second = push_and_rest(bench, into_the_row())
    third = push_and_rest(bench, Push.cardinal((-0.4, 0.0), Direction.RIGHT, 0.5))
    assert third.can_undo
    bench.do(Undo())
    assert bench.until(lambda s: s.scene.version > third.version).scene.poses == second.poses
    bench.do(Undo())
    back = bench.until(lambda s: not s.scene.can_undo).scene
    assert back.poses == first.poses and np.array_equal(back.mask, first.mask)
    again = push_and_rest(bench, into_the_row())
    assert again.poses == second.poses


def test_undo_takes_back_a_push_that_is_under_way(bench):
    before = bench.snapshot.scene
    bench.do(SetSpeed(1.0), PushNow(into_the_row()))
    bench.until(lambda s: s.scene.poses != before.poses)
    bench.do(Undo())
    after = bench.until(lambda s: not s.scene.is_pushing).scene
    assert after.poses == before.poses and after.pusher is None


def test_pause_freezes_a_push_and_step_advances_it_by_one(bench):
    bench.do(SetSpeed(1.0), PushNow(into_the_row()))
    bench.until(lambda s: s.scene.is_pushing and s.scene.pusher is not None)
    bench.do(SetScenePaused(True))
    bench.until(lambda s: s.scene.is_paused)
    frozen = bench.snapshot.scene
    assert {s.scene.motion_count for s in bench.run(0.3)} == {frozen.motion_count}
    for count in (1, 2):
        bench.do(StepScene())
        bench.until(lambda s, n=count: s.scene.motion_count == frozen.motion_count + n)
    assert bench.snapshot.scene.pusher[1] == pytest.approx(frozen.pusher[1] + 0.008, abs=1e-3)
    bench.do(SetSpeed(8.0), SetScenePaused(False))
    bench.until(lambda s: not s.scene.is_pushing)


def test_a_frozen_push_ends_as_one_that_was_never_frozen(bench):
    straight = push_and_rest(bench, into_the_row()).poses
    bench.do(Undo())
    bench.until(lambda s: not s.scene.can_undo)
    bench.do(SetSpeed(2.0), PushNow(into_the_row()))
    bench.until(lambda s: s.scene.pusher is not None)
    bench.do(SetScenePaused(True), StepScene(), SetScenePaused(False), SetSpeed(8.0))
    assert bench.until(lambda s: not s.scene.is_pushing).scene.poses == straight


@pytest.mark.slow
def test_playback_keeps_real_time(bench):
    push = Push.cardinal((-0.6, 0.7), Direction.RIGHT, 0.8)
    durations = {}
    for speed in (1.0, 4.0):
        bench.do(SetSpeed(speed), PushNow(push))
        bench.until(lambda s: s.scene.is_pushing)
        began = time.monotonic()
        bench.until(lambda s: not s.scene.is_pushing)
        durations[speed] = time.monotonic() - began
    assert durations[1.0] == pytest.approx(2.2, abs=1.0)
    assert durations[4.0] < durations[1.0] / 2


@pytest.mark.parametrize(
    ("command", "word"),
    [
        (ResetScene("random-99", 0), "scenario"),
        (ResetScene("random-2", -1), "seed"),
        (ResetScene("random-2", 1.5), "seed"),
        (SetSpeed(math.nan), "speed"),
        (SetSpeed(0.0), "speed"),
        (SetSpeed("fast"), "speed"),
        (PushNow(Push.cardinal((1.5, 0.0), Direction.UP, 0.5)), "push.start"),
        (PushNow(Push.cardinal((0.0, 0.5), Direction.UP, 50.0)), "push.length"),
        (PushNow("up"), "push"),
        ("nonsense", "command"),
        (None, "command"),
    ],
)
def test_a_bad_command_is_a_notice_and_changes_nothing(bench, command, word):
    before = bench.snapshot.scene
    pid = bench.laboratory.pids["scene"]
    known = set(bench.texts)
    bench.do(command)
    bench.until(lambda s: set(bench.texts) - known)
    (text,) = set(bench.texts) - known
    assert word in text and "\n" not in text
    after = bench.run(0.1)[-1].scene
    assert (after.version, after.poses, after.speed) == (
        before.version,
        before.poses,
        before.speed,
    )
    assert bench.laboratory.pids["scene"] == pid


def test_a_killed_process_comes_back_with_its_scene(bench):
    pushed = push_and_rest(bench, into_the_row())
    bench.do(SetSpeed(1.0), PushNow(Push.cardinal((-0.6, 0.0), Direction.RIGHT, 0.5)))
    bench.until(lambda s: s.scene.pusher is not None)
    pid = bench.laboratory.pids["scene"]
    os.kill(pid, signal.SIGKILL)
    bench.until(lambda s: s.scene.version > pushed.version)
    assert bench.laboratory.pids["scene"] != pid
    assert any("scene process was killed (signal 9, SIGKILL)" in text for text in bench.texts)
    after = bench.snapshot.scene
    assert after.poses == pushed.poses and after.seed == pushed.seed and not after.is_pushing
    assert after.can_undo
    assert after.motion_count >= pushed.motion_count
    bench.do(SetSpeed(8.0), Undo())
    bench.until(lambda s: not s.scene.can_undo)
    assert push_and_rest(bench, into_the_row()).poses == pushed.poses


@pytest.mark.slow
def test_poses_come_thirty_times_a_second_and_stop_when_all_is_still():
    process = SupervisedProcess(
        "The scene process",
        "app.processes.scene_process:run_scene",
        arguments=lambda: (SceneStart("fixed-2", 0),),
    )
    try:
        received = []

        def listen(until, timeout_s=60.0):
            deadline = time.monotonic() + timeout_s
            while time.monotonic() < deadline and not (received and until(received[-1][1])):
                received.extend((time.monotonic(), m) for m in process.receive())
                time.sleep(0.002)

        listen(lambda m: m.rest is not None)
        process.send(StartPush(Push.cardinal((-0.6, 0.7), Direction.RIGHT, 0.8), "you", 7))
        listen(lambda m: m.finished is not None)
        assert received[-1][1].finished.push_id == 7
        times = [when for when, message in received if message.live.pusher is not None]
        gaps = np.diff(times)
        assert len(times) > 30 and statistics.median(gaps) < 1 / 30
        time.sleep(0.5)
        assert process.receive() == []
    finally:
        process.close()
