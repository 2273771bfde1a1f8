from dataclasses import replace

import numpy as np
import pytest

from app.fields.catalogue import FIELD_KINDS, FIELDS_BY_KEY, FieldKind
from app.fields.colormaps import SEQUENTIAL
from app.fields.drape import CRISP_SIZE, drape, ingredients, select_direction
from app.panels.watch import Watch
from app.preferences import Preferences
from app.snapshot import RewardMapSnapshot
from singulate.geometry import Direction, Workspace


@pytest.mark.parametrize("kind", FIELD_KINDS, ids=lambda kind: kind.key)
def test_every_field_can_lie_on_the_table(kind: FieldKind, make_snapshot):
    draped = drape(make_snapshot(), Preferences(field=kind.key), Workspace())
    if kind.key == "none":
        assert draped is None
        return
    assert draped is not None
    assert draped.rgba.shape == (CRISP_SIZE, CRISP_SIZE, 4)
    assert draped.rgba.dtype == np.uint8
    assert draped.rgba[..., 3].max() > 0
    assert kind.label in draped.label


def changed_parts(snapshot):
    """Snapshots in each of which something new has arrived."""
    scene, truth, policy, run = (
        snapshot.scene,
        snapshot.reward_map,
        snapshot.policy,
        snapshot.run,
    )
    moved = np.roll(scene.distance_map, 9, axis=0)
    return {
        "scene": replace(
            snapshot,
            scene=replace(
                scene, version=9, distance_map=moved, mask=moved < 0.0, rgb=scene.rgb // 2
            ),
        ),
        "truth": replace(snapshot, reward_map=replace(truth, values=np.roll(truth.values, 3, 1))),
        "late truth": replace(snapshot, reward_map=replace(truth, scene_version=9)),
        "belief": replace(snapshot, policy=replace(policy, q_map=np.roll(policy.q_map, 1, 1))),
        "density": replace(
            snapshot,
            policy=replace(policy, start_density=np.linspace(0, 1, 4096).reshape(64, 64)),
        ),
        "run": replace(snapshot, run=replace(run, starts=run.starts + 0.1, revision=2)),
    }


@pytest.mark.parametrize("kind", FIELD_KINDS, ids=lambda kind: kind.key)
def test_whatever_changes_a_picture_is_among_its_ingredients(kind: FieldKind, make_snapshot):
    snapshot, choices = make_snapshot(), Preferences(field=kind.key)
    before = drape(snapshot, choices, Workspace())
    redrawn = set()
    for part, changed in changed_parts(snapshot).items():
        watch = Watch()
        watch.has_changed(*ingredients(snapshot, kind))
        if watch.has_changed(*ingredients(changed, kind)):
            redrawn.add(part)
            continue
        after = drape(changed, choices, Workspace())
        assert (before is None) == (after is None)
        assert before is None or after is None or np.array_equal(before.rgba, after.rgba), part
    assert redrawn or kind.key == "none"


def test_the_true_reward_is_not_drawn_again_when_only_a_block_has_moved(make_snapshot):
    snapshot, watch = make_snapshot(), Watch()
    changed = changed_parts(snapshot)
    watch.has_changed(*ingredients(snapshot, FIELDS_BY_KEY["reward"]))
    assert not watch.has_changed(*ingredients(changed["scene"], FIELDS_BY_KEY["reward"]))
    assert watch.has_changed(*ingredients(changed["truth"], FIELDS_BY_KEY["reward"]))


def test_the_best_cell_is_where_the_map_has_it(make_snapshot):
    draped = drape(make_snapshot(), Preferences(opacity=1.0), Workspace())
    assert draped is not None
    brightest = (draped.rgba[..., :3] == SEQUENTIAL.table[-1]).all(axis=-1)
    rows, cols = np.nonzero(brightest)
    assert (rows.min(), rows.max()) == (80, 89)
    assert (cols.min(), cols.max()) == (40, 49)


def test_directions_can_be_named_aimed_or_the_best_taken():
    stack = np.stack([np.full((2, 2), float(d)) for d in Direction]).astype(np.float32)
    assert select_direction(stack, "down", Direction.UP).max() == Direction.DOWN
    assert select_direction(stack, "as aimed", Direction.RIGHT).max() == Direction.RIGHT
    assert select_direction(stack, "best", Direction.UP).min() == Direction.LEFT


def test_best_of_a_diverging_map_is_what_is_farthest_from_zero():
    stack = np.zeros((4, 1, 2), np.float32)
    stack[1, 0] = (-5.0, np.nan)
    stack[2, 0] = (3.0, 2.0)
    assert select_direction(stack, "best", Direction.UP, True).tolist() == [[-5.0, 2.0]]


def test_cells_that_no_direction_has_stay_transparent(make_snapshot):
    values = np.zeros((4, 32, 32), np.float32)
    values[:, 0, 0] = np.nan
    values[0, 5, 5] = 1.0
    snapshot = replace(make_snapshot(), reward_map=RewardMapSnapshot(values, 32, 1.0, 3))
    draped = drape(snapshot, Preferences(), Workspace())
    assert draped is not None
    assert draped.rgba[0, 0, 3] == 0
    assert draped.rgba[-1, -1, 3] > 0


@pytest.mark.parametrize(
    ("span", "top"), [("each field", "0"), ("four directions", "1300"), ("reward and Q", "1300")]
)
def test_the_legend_tells_the_chosen_colour_range(span: str, top: str, make_snapshot):
    preferences = Preferences(choice="up", span=span)
    draped = drape(make_snapshot(), preferences, Workspace())
    assert draped is not None
    assert f">{top} reward<" in draped.legend
    assert draped.label.endswith(", up")
