from dataclasses import replace

from app.panels.field_age import policy_line, reward_map_line


def test_the_reward_map_tells_its_resolution_and_progress(make_snapshot):
    snapshot = make_snapshot()
    assert reward_map_line(snapshot) == "32 \N{MULTIPLICATION SIGN} 32 · 25 % done"
    done = replace(snapshot, reward_map=replace(snapshot.reward_map, progress=1.0))
    assert reward_map_line(done) == "32 \N{MULTIPLICATION SIGN} 32"
    assert reward_map_line(replace(snapshot, reward_map=None)) == "not computed yet"


def test_fields_of_an_earlier_table_say_so(make_snapshot, make_scene):
    snapshot = make_snapshot(scene=make_scene(version=4))
    assert reward_map_line(snapshot).endswith("of an earlier table")
    assert policy_line(snapshot).endswith("of an earlier table")


def test_the_agent_is_told_with_its_training(make_snapshot):
    snapshot = make_snapshot()
    assert policy_line(snapshot) == "dqn-a after 20,000 pushes"
    live = replace(snapshot, policy=replace(snapshot.policy, is_live=True))
    assert policy_line(live).endswith("follows the run")
    assert policy_line(replace(snapshot, policy=None)) == "no agent loaded"
