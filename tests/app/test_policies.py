"""The loaded policy: fields on demand, predictions, pushes, and play without end."""

import os
import signal

import numpy as np
import pytest

from app.commands import (
    AgentPush,
    DismissNotice,
    LoadPolicy,
    PushNow,
    ResetScene,
    SetSpeed,
    SetWatching,
)
from singulate import load_policy
from singulate.geometry import Direction, Push


@pytest.fixture(scope="module")
def bench(make_bench, untrained):
    bench = make_bench(scenario="random-2", seed=1, checkpoints_dir=untrained)
    bench.do(SetSpeed(8.0))
    return bench


def load(bench, directory):
    bench.do(LoadPolicy(str(directory)))
    return bench.until(lambda s: s.policy is not None and s.policy.source == str(directory)).policy


def predicted_report(bench, push):
    """The report of a push; on a busy machine, its prediction comes after it."""
    return bench.until(
        lambda s: (
            s.scene.last_push is not None
            and s.scene.last_push.push == push
            and s.scene.last_push.predicted is not None
        )
    ).scene.last_push


def test_policies_are_listed_by_the_label_they_have_once_loaded(bench, untrained):
    bench.until(lambda s: len(s.policies) == 3)
    listed = dict(bench.snapshot.policies)
    policy = load(bench, untrained / "dqn-untrained")
    assert listed[policy.label] == policy.source
    assert policy.label == "dqn-untrained · 1,234 steps"
    assert (policy.kind, policy.num_steps, policy.is_live) == ("dqn", 1234, False)


def test_fields_are_computed_only_when_wanted_and_follow_the_scene(bench, untrained):
    load(bench, untrained / "dqn-untrained")
    assert all(s.policy.q_map is None for s in bench.run(0.3))
    bench.laboratory.set_wanted_fields({"q_map", "start_density"})
    policy = bench.until(lambda s: s.policy.q_map is not None).policy
    expected = load_policy(untrained / "dqn-untrained").q_map(bench.snapshot.scene.distance_map)
    assert np.allclose(policy.q_map, expected, rtol=1e-4) and policy.q_map.shape[0] == 4
    assert policy.scene_version == bench.snapshot.scene.version
    bench.do(ResetScene("random-2", 2))
    bench.until(lambda s: s.scene.seed == 2)
    bench.until(lambda s: s.policy.scene_version == s.scene.version)
    assert not np.array_equal(bench.snapshot.policy.q_map, policy.q_map)


def test_a_ppo_has_a_density_of_starts_and_no_q_map(bench, untrained):
    bench.laboratory.set_wanted_fields({"q_map", "start_density"})
    load(bench, untrained / "ppo-untrained")
    policy = bench.until(lambda s: s.policy.start_density is not None).policy
    density = policy.start_density
    assert all(density[mode] > np.median(density) for mode in policy.start_modes)
    assert policy.start_modes
    assert policy.q_map is None
    assert policy.start_density.shape == (64, 64)
    assert policy.start_density.sum() == pytest.approx(1.0, abs=1e-3)


def test_a_spatial_agent_has_a_q_map_as_fine_as_the_picture(bench, untrained):
    bench.laboratory.set_wanted_fields({"q_map", "start_density"})
    load(bench, untrained / "spatial-untrained")
    policy = bench.until(lambda s: s.policy.q_map is not None).policy
    assert policy.start_density is None
    assert policy.q_map.shape == (4, 64, 64)
    expected = load_policy(untrained / "spatial-untrained")
    seen = bench.snapshot.scene.distance_map
    assert np.allclose(policy.q_map, expected.q_map(seen), rtol=1e-3, atol=1e-2)


def test_a_spatial_agent_predicts_a_push_from_its_very_start(bench, untrained):
    load(bench, untrained / "spatial-untrained")
    observation = bench.snapshot.scene.distance_map
    push = Push.cardinal((-0.527, 0.313), Direction.LEFT, 0.5)
    bench.do(PushNow(push))
    report = predicted_report(bench, push)
    expected = load_policy(untrained / "spatial-untrained").predict_value(observation, push)
    assert report.predicted == pytest.approx(expected, rel=1e-3, abs=1e-2)


def test_a_push_is_predicted_by_the_cell_of_the_q_map(bench, untrained):
    load(bench, untrained / "dqn-untrained")
    observation = bench.snapshot.scene.distance_map
    push = Push.cardinal((-0.52, 0.31), Direction.LEFT, 0.3)
    bench.do(PushNow(push))
    report = predicted_report(bench, push)
    q_map = load_policy(untrained / "dqn-untrained").q_map(observation)
    cells = q_map.shape[1]
    row, col = int((1 - 0.31) / 2 * cells), int((1 - 0.52) / 2 * cells)
    assert report.predicted == pytest.approx(q_map[Direction.LEFT, row, col], rel=1e-3)


def test_the_agent_pushes_where_it_would(bench, untrained):
    load(bench, untrained / "dqn-untrained")
    expected = load_policy(untrained / "dqn-untrained").act(bench.snapshot.scene.distance_map)
    version = bench.snapshot.scene.version
    bench.do(AgentPush())
    report = bench.until(lambda s: s.scene.version > version).scene.last_push
    assert report.by == "agent" and report.push == expected


def test_watching_pushes_and_moves_on_to_the_next_seed(bench, untrained):
    load(bench, untrained / "dqn-untrained")
    bench.do(SetSpeed(8.0), ResetScene("random-2", 10))
    bench.until(lambda s: s.scene.seed == 10)
    bench.do(SetWatching(True))
    bench.until(lambda s: s.scene.is_watching and s.scene.seed == 12)
    bench.do(SetWatching(False))
    bench.until(lambda s: not s.scene.is_watching and not s.scene.is_pushing)
    seed = bench.snapshot.scene.seed
    assert {s.scene.seed for s in bench.run(0.5)} == {seed}


def test_a_bad_checkpoint_is_told_and_the_old_policy_stays(bench, untrained, tmp_path):
    policy = load(bench, untrained / "ppo-untrained")
    bench.do(LoadPolicy(str(tmp_path / "nowhere")))
    bench.until(lambda s: any("no such checkpoint" in text for text in bench.texts))
    assert bench.snapshot.policy.source == policy.source
    notice = bench.snapshot.notices[-1]
    bench.do(DismissNotice(notice.notice_id), DismissNotice(999))
    bench.until(lambda s: notice not in s.notices)


def test_following_a_run_needs_one(bench, untrained):
    policy = load(bench, untrained / "dqn-untrained")
    known = set(bench.texts)
    bench.do(LoadPolicy("run"))
    bench.until(lambda s: set(bench.texts) - known)
    (text,) = set(bench.texts) - known
    assert "a watched run with a checkpoint" in text
    assert (bench.snapshot.policy.source, bench.snapshot.policy.is_live) == (policy.source, False)


def test_a_killed_process_loads_its_policy_again(bench, untrained):
    load(bench, untrained / "dqn-untrained")
    pid = bench.laboratory.pids["policy"]
    os.kill(pid, signal.SIGKILL)
    bench.until(lambda s: any("policy process was killed" in text for text in bench.texts))
    version = bench.snapshot.scene.version
    bench.do(AgentPush())
    bench.until(lambda s: s.scene.version > version)
    assert bench.snapshot.policy.source == str(untrained / "dqn-untrained")


def test_without_a_policy_nobody_pushes(make_bench):
    bench = make_bench()
    bench.do(AgentPush(), SetWatching(True))
    bench.until(lambda s: sum("load or train one" in text for text in bench.texts) == 2)
    assert not bench.snapshot.scene.is_watching and bench.snapshot.policies == ()


def test_the_shipped_checkpoint_is_loaded_at_first(make_bench, untrained, tmp_path):
    (tmp_path / "spatial").symlink_to(untrained / "dqn-untrained")
    bench = make_bench(checkpoints_dir=tmp_path)
    policy = bench.until(lambda s: s.policy is not None).policy
    assert policy.label == "spatial · 1,234 steps"
    assert (bench.snapshot.scene.scenario, bench.snapshot.scene.seed) == ("random-2", 0)
