from dataclasses import replace

import numpy as np
import pytest

from app.fields.catalogue import FIELD_KINDS, FIELDS_BY_KEY, FieldKind, window_of
from app.preferences import Preferences
from app.snapshot import Snapshot
from singulate.geometry import Direction, Workspace

EMPTY = Snapshot(None, None, None, None)


@pytest.mark.parametrize("kind", FIELD_KINDS, ids=lambda kind: kind.key)
def test_every_field_waits_quietly_for_its_data(kind: FieldKind):
    assert kind.read(EMPTY, Preferences(), Workspace()) is None


@pytest.mark.parametrize("kind", FIELD_KINDS[1:], ids=lambda kind: kind.key)
def test_every_field_has_the_shape_that_it_promises(kind: FieldKind, make_snapshot):
    values = kind.read(make_snapshot(), Preferences(), Workspace())
    assert values is not None
    if kind.is_directional:
        assert values.ndim == 3 and len(values) == 4
    else:
        assert values.ndim == (3 if kind.key == "camera" else 2)


def test_keys_and_labels_are_unique():
    assert len({kind.key for kind in FIELD_KINDS}) == len(FIELD_KINDS)
    assert len({kind.label for kind in FIELD_KINDS}) == len(FIELD_KINDS)


def test_the_error_is_belief_minus_truth_at_the_finer_resolution(make_snapshot):
    snapshot = make_snapshot()
    error = FIELDS_BY_KEY["error"].read(snapshot, Preferences(), Workspace())
    assert error is not None and error.shape == (4, 32, 32)
    row, col = 8, 4
    expected = snapshot.policy.q_map[Direction.RIGHT, 2, 1] - 1300.0
    assert error[Direction.RIGHT, row, col] == pytest.approx(expected)


def test_truth_and_belief_about_different_tables_are_not_subtracted(make_snapshot):
    snapshot = make_snapshot()
    other = replace(snapshot.policy, scene_version=99)
    read = FIELDS_BY_KEY["error"].read
    assert read(replace(snapshot, policy=other), Preferences(), Workspace()) is None


def test_the_window_follows_the_run_or_stands_where_it_was_put(make_snapshot):
    snapshot = make_snapshot()
    assert window_of(snapshot, Preferences(window_size=256)) == (745, 1000)
    assert window_of(snapshot, Preferences(window_size=256, window_end=300)) == (45, 300)
    assert window_of(snapshot, Preferences(window_size=2048)) == (0, 1000)
    assert window_of(EMPTY, Preferences()) is None


def test_the_histogram_shows_the_chosen_window(make_snapshot):
    read = FIELDS_BY_KEY["start_histogram"].read
    early = read(make_snapshot(), Preferences(window_end=400, window_size=256), Workspace())
    late = read(make_snapshot(), Preferences(window_size=256), Workspace())
    assert early is not None and late is not None
    assert early.sum() == late.sum() == 256
    assert not np.array_equal(early, late)
