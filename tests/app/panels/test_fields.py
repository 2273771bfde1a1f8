from dataclasses import replace

from app.fields.catalogue import FIELD_KINDS
from app.panels.fields import FieldsPanel
from app.snapshot import Snapshot


def test_truth_belief_and_inputs_are_drawn(context, make_snapshot):
    panel = FieldsPanel(context)
    panel.update(make_snapshot(), 0.0)
    assert panel.reward.content.count("<img") == 4
    assert panel.q.content.count("<img") == 4
    assert panel.inputs.content.count("<img") == 4
    assert "Starts, 1 mode" in panel.inputs.content
    assert panel.inputs.content.count("border-radius:50%") == 1


def test_nothing_is_drawn_again_without_a_change(context, make_snapshot):
    panel = FieldsPanel(context)
    snapshot = make_snapshot()
    panel.update(snapshot, 0.0)
    for drawn in (panel.reward, panel.q, panel.inputs):
        drawn.content = "left alone"
    panel.update(snapshot, 1.0)
    assert {panel.reward.content, panel.q.content, panel.inputs.content} == {"left alone"}


def test_pictures_change_at_most_four_times_a_second(context, make_snapshot):
    panel = FieldsPanel(context)
    snapshot = make_snapshot()
    panel.update(snapshot, 0.0)
    before = panel.reward.content
    finer = replace(snapshot.reward_map, progress=0.5)
    changed = replace(snapshot, reward_map=finer)
    panel.update(changed, 0.1)
    assert panel.reward.content is before
    panel.update(changed, 0.3)
    assert "50 %" in panel.reward.content


def test_turning_pages_visits_every_field_and_comes_back(context):
    panel = FieldsPanel(context)
    seen = []
    for _ in FIELD_KINDS:
        panel.turn_page(1)
        seen.append(context.preferences.field)
    assert sorted(seen) == sorted(kind.key for kind in FIELD_KINDS)
    panel.turn_page(-1)
    assert context.preferences.field == seen[-2]


def test_the_form_follows_the_keys(context, make_snapshot):
    panel = FieldsPanel(context)
    context.preferences.field = "camera"
    panel.update(make_snapshot(), 0.0)
    assert panel.field.value == "Camera image"
    assert not panel.choice.visible


def test_hidden_directions_are_not_drawn(context, make_snapshot):
    panel = FieldsPanel(context)
    context.preferences.shows_all_directions = False
    panel.update(make_snapshot(), 0.0)
    assert not panel.reward.visible and not panel.q.visible
    assert panel.reward.content == ""


def test_ranges_of_their_own_give_each_picture_a_legend(context, make_snapshot):
    panel = FieldsPanel(context)
    context.preferences.span = "each field"
    panel.update(make_snapshot(), 0.0)
    assert panel.reward.content.count("singulate-legend") == 4


def test_an_agent_without_q_values_says_so(context, make_snapshot):
    panel = FieldsPanel(context)
    snapshot = make_snapshot()
    policy = replace(snapshot.policy, kind="ppo", has_q_map=False, q_map=None)
    panel.update(replace(snapshot, policy=policy), 0.0)
    assert "ppo has no Q values" in panel.q.content


def test_q_values_that_are_still_computed_are_not_denied(context, make_snapshot):
    panel = FieldsPanel(context)
    snapshot = make_snapshot()
    policy = replace(snapshot.policy, kind="sac", q_map=None)
    panel.update(replace(snapshot, policy=policy), 0.0)
    assert "no Q values" not in panel.q.content


def test_an_inspected_place_is_listed(context, make_snapshot):
    panel = FieldsPanel(context)
    panel.update(make_snapshot(), 0.0)
    assert not panel.inspection.visible
    context.preferences.click_inspects = True
    context.preferences.inspected = (0.5, 0.5)
    panel.update(make_snapshot(), 1.0)
    assert panel.inspection.visible
    assert "(0.50, 0.50) m" in panel.inspection.content


def test_an_empty_laboratory_is_shown_quietly(context):
    panel = FieldsPanel(context)
    panel.update(Snapshot(None, None, None, None), 0.0)
    assert "not computed yet" in panel.reward.content
    assert "no agent loaded" in panel.q.content
