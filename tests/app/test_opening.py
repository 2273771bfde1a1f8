"""A page finds what it opens with."""

import shutil
import threading
import time

import pytest

from app.laboratory import FIRST_POLICY, Laboratory
from app.opening import LONGEST_PREPARATION_S, prepare_opening
from singulate.geometry import Workspace
from singulate.paths import shipped_checkpoints_directory


@pytest.fixture
def open_laboratory(tmp_path):
    opened = []

    def make(checkpoints_dir):
        opened.append(
            Laboratory(
                "fixed-2",
                runs_dir=tmp_path / "runs",
                checkpoints_dir=checkpoints_dir,
                num_workers=1,
            )
        )
        return opened[-1]

    yield make
    for laboratory in opened:
        laboratory.close()


def prepare(laboratory, stop=None):
    return prepare_opening(laboratory, Workspace(), stop or threading.Event())


def test_the_scene_and_all_fields_of_a_new_page_are_there(open_laboratory):
    laboratory = open_laboratory(shipped_checkpoints_directory())
    assert prepare(laboratory)
    snapshot = laboratory.tick()
    assert snapshot.scene is not None
    assert snapshot.reward_map.progress == 1.0
    assert snapshot.policy.label.startswith(FIRST_POLICY)
    assert snapshot.policy.q_map.std() > 0.0
    assert snapshot.policy.scene_version == snapshot.reward_map.scene_version


def test_where_no_policy_is_shipped_none_is_waited_for(open_laboratory, tmp_path):
    laboratory = open_laboratory(tmp_path / "none")
    begin = time.monotonic()
    assert prepare(laboratory)
    assert time.monotonic() - begin < LONGEST_PREPARATION_S


def test_a_policy_that_cannot_be_loaded_is_not_waited_for(open_laboratory, tmp_path):
    damaged = tmp_path / "checkpoints" / FIRST_POLICY
    shutil.copytree(shipped_checkpoints_directory() / FIRST_POLICY, damaged)
    next(damaged.glob("*.safetensors")).write_bytes(b"damaged")
    laboratory = open_laboratory(damaged.parent)
    assert not prepare(laboratory)
    assert FIRST_POLICY in laboratory.tick().notices[0].text


def test_it_ends_when_it_is_told_to(open_laboratory):
    stop = threading.Event()
    stop.set()
    assert not prepare(open_laboratory(shipped_checkpoints_directory()), stop)
