from dataclasses import replace

from app.commands import ResetScene, SetScenePaused, StepScene
from app.panels.interact import InteractPanel
from app.snapshot import Snapshot
from singulate.geometry import Direction


def test_an_empty_laboratory_is_shown_quietly(context, submitted):
    panel = InteractPanel(context)
    panel.update(Snapshot(None, None, None, None))
    assert "being set up" in panel.state.content
    assert panel.agent_push.disabled
    assert submitted == []


def test_the_form_follows_the_shared_scene_without_commanding_it(
    context, make_snapshot, make_scene, submitted
):
    panel = InteractPanel(context)
    panel.update(make_snapshot())
    assert (panel.scenario.value, panel.seed.value) == ("random-2", 7)
    panel.update(make_snapshot(scene=make_scene(scenario="cluster-5", seed=9, speed=2.0)))
    assert (panel.scenario.value, panel.seed.value, panel.speed.value) == ("cluster-5", 9, 2.0)
    assert submitted == []


def test_reset_takes_the_form(context, make_snapshot, submitted):
    panel = InteractPanel(context)
    panel.update(make_snapshot())
    panel.reset()
    assert submitted == [ResetScene("random-2", 7)]


def test_pause_follows_the_one_state(context, make_snapshot, make_scene, submitted):
    panel = InteractPanel(context)
    panel.update(make_snapshot())
    panel.pause_or_go()
    panel.update(make_snapshot(scene=make_scene(is_paused=True)))
    assert panel.motion.options[0] == "Go on"
    panel.pause_or_go()
    panel.step()
    assert submitted == [SetScenePaused(True), SetScenePaused(False), StepScene()]


def test_a_step_freezes_a_moving_scene_first(context, make_snapshot, submitted):
    panel = InteractPanel(context)
    panel.update(make_snapshot())
    panel.step()
    assert submitted == [SetScenePaused(True), StepScene()]


def test_the_chosen_direction_is_marked(context, make_snapshot):
    panel = InteractPanel(context)
    context.preferences.direction = Direction.DOWN
    panel.update(make_snapshot())
    assert [option[0] for option in panel.directions.handle.options] == ["△", "▷", "▼", "◁"]


def test_the_loaded_policy_is_in_the_list_even_if_it_is_not_offered(context, make_snapshot):
    panel = InteractPanel(context)
    snapshot = make_snapshot()
    panel.update(replace(snapshot, policy=replace(snapshot.policy, label="mine")))
    assert panel.policy.value == "mine"
    assert panel.policy.options == ("mine", "dqn-a", "ppo-b")


def test_what_is_going_on_is_told(context, make_snapshot, make_scene):
    panel = InteractPanel(context)
    panel.update(make_snapshot(scene=make_scene(is_pushing=True, pushed_by="visitor 2")))
    assert "visitor 2 pushing" in panel.state.content
    own = InteractPanel(replace(context, name="visitor 2"))
    own.update(make_snapshot(scene=make_scene(is_pushing=True, pushed_by="visitor 2")))
    assert "you pushing" in own.state.content
    panel.update(make_snapshot(scene=make_scene(is_success=True)))
    assert "singulated" in panel.state.content
