"""The camera's pixels against true poses."""

import math

import numpy as np
import pytest

from singulate.geometry import Block, Direction, Push, Workspace, standing_pose
from singulate.perception import perceive
from singulate.simulation import Scene, make_scenario
from singulate.simulation.pixel_window import window_of

WORKSPACE = Workspace()
PIXEL = WORKSPACE.metres_per_pixel


def true_mask(block: Block) -> np.ndarray:
    """Pixels whose centre lies on an upright block."""
    x, y = np.moveaxis(WORKSPACE.cell_centres(), -1, 0)
    return np.maximum(abs(x - block.x), abs(y - block.y)) < block.side / 2


def test_a_block_at_the_centre_covers_the_pixels_whose_centres_it_covers(scene):
    block = Block(0.01, -0.02, 0.2)
    scene.place((block,))
    mask = perceive(scene.photograph(), WORKSPACE).mask
    assert (mask == true_mask(block)).all()


def test_masks_are_within_one_pixel_of_the_truth_anywhere(scene):
    rng = np.random.default_rng(0)
    wrong = []
    for _ in range(40):
        block = Block(*rng.uniform(-0.85, 0.85, 2), rng.uniform(0.15, 0.25))
        scene.place((block,))
        mask = perceive(scene.photograph(), WORKSPACE).mask
        truth = true_mask(block)
        rows, cols = np.nonzero(truth)
        reach = np.zeros_like(truth)
        reach[max(rows.min() - 1, 0) : rows.max() + 2, max(cols.min() - 1, 0) : cols.max() + 2] = 1
        assert not (mask & ~reach).any()
        wrong.append((mask != truth).sum())
    # A block covers about 40 pixels; less than one row or column of them is off on average.
    assert np.mean(wrong) < 6


def test_image_row_0_is_plus_y_and_column_0_is_minus_x(scene):
    scene.place((Block(-0.8, 0.8),))
    rows, cols = np.nonzero(perceive(scene.photograph(), WORKSPACE).mask)
    assert rows.max() < 12
    assert cols.max() < 12


@pytest.mark.parametrize("gap", [0.05, 0.1, 0.2, 0.5])
def test_measured_separations_are_within_one_pixel_of_the_truth(scene, gap):
    rng = np.random.default_rng(int(gap * 100))
    errors = []
    for _ in range(20):
        x, y = rng.uniform(-0.3, 0.3, 2)
        scene.place((Block(x - 0.1, y), Block(x + 0.1 + gap, y)))
        (measured,) = perceive(scene.photograph(), WORKSPACE).separations
        errors.append(measured - gap)
    assert np.abs(errors).max() < PIXEL
    assert abs(np.mean(errors)) < 0.5 * PIXEL


def test_the_pusher_is_never_in_the_picture(scene):
    scene.place((Block(0.0, 0.0),))
    scene.push(Push.cardinal((0.0, -0.3), Direction.UP, 0.5))
    assert perceive(scene.photograph(), WORKSPACE).num_segments == 1


def test_the_picture_depends_on_the_poses_alone(scene):
    rng = np.random.default_rng(1)
    scenario = make_scenario("cluster-5")
    scene.place(scenario.sample(rng, WORKSPACE))
    poses, frame = scene.poses, scene.photograph()
    for _ in range(5):
        scene.picture()
        scene.place(scenario.sample(rng, WORKSPACE))
        scene.push(Push.cardinal((0.0, -0.5), Direction.UP, 0.5))
        scene.restore(poses)
        again = scene.photograph()
        assert (again.depth == frame.depth).all()
        assert (again.rgb == frame.rgb).all()


def test_the_picture_for_people_shows_table_and_blocks(scene):
    scene.place((Block(0.0, 0.0), Block(0.2, 0.0)))
    picture = scene.picture(320, 240)
    assert picture.shape == (240, 320, 3)
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 5


def test_a_picture_without_the_table_shows_the_same_blocks_in_the_same_pixels(scene):
    rng = np.random.default_rng(2)
    for name in ("random-2", "cluster-6", "random-3") * 5:
        scene.place(make_scenario(name).sample(rng, WORKSPACE))
        scene.push(Push.cardinal((0.0, -0.5), Direction.UP, 0.5))
        with_table = perceive(scene.photograph(), WORKSPACE)
        without = perceive(scene.photograph_blocks(), WORKSPACE)
        assert (with_table.mask == without.mask).all()
        assert (with_table.label_image == without.label_image).all()


def test_a_window_holds_tall_blocks_at_the_border_of_a_fine_picture():
    fine = Workspace(image_size=512)
    with Scene(fine) as scene:
        for x, y, yaw in ((0.7, 0.7, 0.0), (-0.6, -0.6, math.pi / 4), (-0.7, 0.1, 0.2)):
            scene.place((Block(x, y, 0.5, yaw),))
            full = perceive(scene.photograph(), fine)
            assert (perceive(scene.photograph_blocks(), fine).mask == full.mask).all()


def test_an_empty_table_has_no_window_and_a_plain_picture():
    assert window_of((), WORKSPACE) is None
    beside = standing_pose(Block(0.95, -0.95))
    assert window_of((beside,), WORKSPACE) == (57, 64, 57, 64)
