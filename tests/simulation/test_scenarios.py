"""Scenarios put up what their names promise, and the generator alone decides."""

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import Workspace, layout_to_dicts, parse_layout
from singulate.geometry.rectangle import distance
from singulate.simulation import make_scenario
from singulate.simulation.scenarios.registry import scenario_names

WORKSPACE = Workspace()


@pytest.mark.parametrize("name", scenario_names())
def test_every_scene_is_a_valid_layout_of_the_promised_size(name):
    scenario = make_scenario(name)
    for seed in range(20):
        layout = scenario.sample(np.random.default_rng(seed), WORKSPACE)
        assert len(layout) == scenario.num_blocks
        assert parse_layout(layout_to_dicts(layout), WORKSPACE) == layout


@pytest.mark.parametrize("name", scenario_names())
def test_all_blocks_hang_together_face_to_face(name):
    layout = make_scenario(name).sample(np.random.default_rng(3), WORKSPACE)
    reached, waiting = {0}, [0]
    while waiting:
        block = layout[waiting.pop()]
        for i, other in enumerate(layout):
            if i not in reached and distance(block.footprint, other.footprint) < 1e-6:
                reached.add(i)
                waiting.append(i)
    assert reached == set(range(len(layout)))


def test_fixed_scenes_are_equal_blocks_in_a_row_at_the_origin():
    layout = make_scenario("fixed-3").sample(np.random.default_rng(0), WORKSPACE)
    found = np.array([(b.x, b.y, b.side) for b in layout])
    assert found == pytest.approx(np.array([(-0.2, 0.0, 0.2), (0.0, 0.0, 0.2), (0.2, 0.0, 0.2)]))


def test_random_rows_vary_in_place_side_and_direction():
    scenario = make_scenario("random-2")
    layouts = [scenario.sample(np.random.default_rng(seed), WORKSPACE) for seed in range(200)]
    sides = np.array([[b.side for b in layout] for layout in layouts])
    centres = np.array([[layout[0].x, layout[0].y] for layout in layouts])
    along_x = np.mean([layout[0].y == layout[1].y for layout in layouts])
    assert 0.15 <= sides.min() < 0.16
    assert 0.24 < sides.max() <= 0.25
    assert (centres.std(axis=0) > 0.3).all()
    assert 0.35 < along_x < 0.65


def test_the_same_generator_state_gives_the_same_scene():
    scenario = make_scenario("cluster-7")
    first, second = (scenario.sample(np.random.default_rng(9), WORKSPACE) for _ in range(2))
    assert first == second
    assert first != scenario.sample(np.random.default_rng(10), WORKSPACE)


@pytest.mark.parametrize(
    ("name", "pushes"), [("fixed-2", 1), ("random-3", 1), ("random-4", 4), ("cluster-3", 3)]
)
def test_rows_of_two_and_three_take_one_push_and_others_one_for_each_block(name, pushes):
    assert make_scenario(name).default_max_pushes == pushes


@pytest.mark.parametrize(
    "name",
    ["fixed-4", "random-1", "cluster-11", "random", "random-02", "", None, "random-2+", "+"],
)
def test_an_unknown_scenario_is_refused_with_what_is_allowed(name):
    with pytest.raises(InvalidValueError, match=r"scenario: .* allowed: fixed-2\.\.3, random-2"):
        make_scenario(name)


def test_a_mix_draws_scenes_of_all_its_parts_alike():
    scenario = make_scenario("random-2+cluster-5")
    layouts = [scenario.sample(np.random.default_rng(seed), WORKSPACE) for seed in range(200)]
    sizes = [len(layout) for layout in layouts]
    assert set(sizes) == {2, 5}
    assert 0.35 < sizes.count(2) / len(sizes) < 0.65
    assert scenario.name == "random-2+cluster-5"
    assert scenario.num_blocks == 5
    assert scenario.default_max_pushes == 5
    assert make_scenario("random-2+random-3").default_max_pushes == 1


def test_a_mix_is_of_a_few_scenarios():
    with pytest.raises(InvalidValueError, match="a mix of at most 8 scenarios"):
        make_scenario("+".join(["random-2"] * 9))
