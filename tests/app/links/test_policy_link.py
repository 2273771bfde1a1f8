"""The laboratory's end of the policy process, where its messages cross and its process dies."""

import os
import signal
import time

import numpy as np
import pytest

from app.links.policy_link import Q_MAP, PolicyLink
from app.notices import NoticeBoard
from app.processes import supervised
from app.processes.scene_messages import RestState, SavedScene
from singulate.envs.push_task import PushTask
from singulate.simulation import make_scenario


@pytest.fixture(scope="module")
def percept():
    task = PushTask()
    task.place(make_scenario("random-2").sample(np.random.default_rng(0), task.workspace))
    yield task.percept
    task.close()


@pytest.fixture
def make_rest(percept):
    scene = SavedScene("random-2", 0, 2, (), 0)
    rgb = np.zeros((64, 64, 3), np.uint8)
    return lambda version: RestState(version, scene, (), 5, percept, rgb, False, False)


@pytest.fixture
def notices():
    return NoticeBoard()


@pytest.fixture
def link(notices):
    link = PolicyLink(notices, lambda: None)
    yield link
    link.close()


def until(link, condition, rest, wanted=frozenset(), timeout_s=60.0):
    """Every picture that was published until something is so, and the answers on the way."""
    deadline = time.monotonic() + timeout_s
    seen, answers = [], []
    while time.monotonic() < deadline:
        answers += link.update(rest, wanted)
        seen.append(link.snapshot)
        if condition(answers):
            return seen
        time.sleep(0.005)
    raise AssertionError("waited in vain")


def has_q_map(link, source):
    policy = link.snapshot
    return policy is not None and policy.source == str(source) and policy.q_map is not None


@pytest.fixture
def twins(untrained, tmp_path):
    """Two checkpoints of the same kind."""
    for name in ("first", "second"):
        (tmp_path / name).symlink_to(untrained / "dqn-untrained")
    return tmp_path / "first", tmp_path / "second"


def test_a_question_that_crosses_a_load_does_not_end_the_fields(link, make_rest, twins):
    first, second = twins
    link.load(str(first))
    until(link, lambda _: has_q_map(link, first), make_rest(1), {Q_MAP})
    link.load(str(second))
    link.update(make_rest(2), {Q_MAP})  # asks before the second one is known to be loaded
    until(link, lambda _: has_q_map(link, second), make_rest(2), {Q_MAP})
    until(link, lambda _: link.snapshot.scene_version == 3, make_rest(3), {Q_MAP})
    assert has_q_map(link, second)


def test_fields_are_never_shown_under_the_name_of_another_policy(link, make_rest, twins):
    first, second = twins
    link.load(str(first))
    until(link, lambda _: has_q_map(link, first), make_rest(1), {Q_MAP})
    of_first = link.snapshot.q_map
    link.load(str(second))
    seen = until(link, lambda _: link.snapshot.source == str(second), make_rest(1), {Q_MAP})
    assert all(policy.q_map is of_first for policy in seen[:-1])
    assert seen[-1].q_map is not of_first


def test_fields_that_nobody_wants_leave_with_their_policy(link, make_rest, twins):
    first, second = twins
    link.load(str(first))
    until(link, lambda _: has_q_map(link, first), make_rest(1), {Q_MAP})
    link.load(str(second))
    until(link, lambda _: link.snapshot.source == str(second), make_rest(1))
    assert link.snapshot.q_map is None


def test_a_rest_after_many_deaths_loses_no_policy(link, notices, make_rest, untrained, monkeypatch):
    monkeypatch.setattr(supervised, "_HOLD_OFF_S", 0.5)
    source = str(untrained / "dqn-untrained")
    link.load(source)
    until(link, lambda _: link.is_loaded, make_rest(1))
    for _ in range(4):
        pid = link.pid
        os.kill(pid, signal.SIGKILL)
        until(link, lambda _, p=pid: link.pid != p or "keeps" in str(texts(notices)), make_rest(1))
    assert "keeps ending" in notices.notices[-1].text
    link.choose(make_rest(1))
    assert "did not take the question" in notices.notices[-1].text
    until(link, lambda _: link.pid != pid, make_rest(1))
    link.choose(make_rest(1))
    until(link, lambda answers: len(answers) == 1, make_rest(1))


def test_a_policy_that_is_gone_when_its_process_is_restarted_is_gone(
    link, notices, make_rest, twins
):
    first, second = twins
    link.load(str(first))
    until(link, lambda _: link.is_loaded, make_rest(1))
    first.unlink()
    os.kill(link.pid, signal.SIGKILL)
    until(link, lambda _: not link.is_loaded, make_rest(1), {Q_MAP})
    assert link.snapshot is None
    assert any("no such checkpoint" in text for text in texts(notices))
    first.symlink_to(second.resolve())
    link.load(str(first))
    until(link, lambda _: has_q_map(link, first), make_rest(1), {Q_MAP})


def texts(notices):
    return [notice.text for notice in notices.notices]
