import dataclasses

import gymnasium
import numpy as np
import pytest

import singulate  # noqa: F401  registers the environment
from singulate.engine import LocalEngine
from singulate.geometry import Direction, Poses, Workspace, standing_pose
from singulate.rewardmap import RewardMapRequest, compute_reward_map
from singulate.rewardmap.plain_pushes import cell_push, plain_pushes, split
from singulate.rewardmap.reach import reaching_starts
from singulate.rewards import REWARDS
from singulate.simulation import Physics, make_scenario


@pytest.mark.parametrize(("scenario", "seed"), [("random-3", 5), ("cluster-4", 1)])
def test_the_map_is_what_the_environment_pays(
    engine: LocalEngine, scenario: str, seed: int
) -> None:
    layout = make_scenario(scenario).sample(np.random.default_rng(seed), Workspace())
    poses = tuple(standing_pose(block) for block in layout)
    request = RewardMapRequest(poses, resolution=10)
    values = compute_reward_map(request, engine, algorithm=plain_pushes).values
    idle = np.median(values, axis=None)
    actions = np.flatnonzero(values != idle)[::5]  # actions of the grid are flat map indices
    env = gymnasium.make("singulate/Push-v0", scenario=scenario, action="grid")
    for action in actions:
        env.reset(seed=seed)
        _, reward, _, _, info = env.step(int(action))
        assert np.float32(reward) == values.flat[action], (action, info["reward_terms"])
    env.close()
    assert len(actions) > 30


def test_an_exact_map_differs_where_a_block_is_touched_at_most(
    engine: LocalEngine, pushed_poses: Poses
) -> None:
    quick = RewardMapRequest(pushed_poses, resolution=12)
    plain = compute_reward_map(quick, engine, algorithm=plain_pushes).values
    exact = compute_reward_map(dataclasses.replace(quick, exact=True), engine).values
    workspace = Workspace()
    can_touch = reaching_starts(pushed_poses, workspace, 12, Physics().pusher_side)
    np.testing.assert_array_equal(plain[~can_touch], exact[~can_touch])
    assert np.isclose(plain, exact, atol=50.0)[can_touch].mean() > 0.9


def test_the_number_of_workers_changes_nothing(engine: LocalEngine, pushed_poses: Poses) -> None:
    request = RewardMapRequest(pushed_poses, resolution=12)
    two = compute_reward_map(request, engine, algorithm=plain_pushes)
    with LocalEngine(num_workers=1) as alone:
        one = compute_reward_map(request, alone, algorithm=plain_pushes)
    assert one.values.tobytes() == two.values.tobytes()


def test_a_start_on_a_block_pays_the_penalty(engine: LocalEngine, row_poses: Poses) -> None:
    values = compute_reward_map(RewardMapRequest(row_poses, resolution=16), engine).values
    for pose in row_poses:
        row, col = Workspace().xy_to_row_col(*pose.position[:2], resolution=16)
        assert (values[:, row, col] == -100.0).all()


def test_fixed_row_has_a_winning_push_that_a_mirror_shows_too(engine: LocalEngine) -> None:
    layout = make_scenario("fixed-2").sample(np.random.default_rng(0), Workspace())
    poses = tuple(standing_pose(block) for block in layout)
    values = compute_reward_map(RewardMapRequest(poses, resolution=16), engine).values
    wins = values > 1000.0
    assert wins[Direction.UP].any()
    assert wins[Direction.DOWN].any()
    assert not wins[Direction.UP, :4].any()  # above the blocks, pushing away from them


@pytest.mark.parametrize("reward", sorted(REWARDS))
def test_every_reward_has_a_map(engine: LocalEngine, row_poses: Poses, reward: str) -> None:
    request = RewardMapRequest(row_poses, resolution=6, reward=reward)
    values = compute_reward_map(request, engine).values
    assert np.isfinite(values).all()
    assert values.dtype == np.float32
    assert values.shape == (4, 6, 6)


def test_an_empty_table_has_a_flat_map(engine: LocalEngine) -> None:
    values = compute_reward_map(RewardMapRequest((), resolution=8), engine).values
    # No start is near an object, and nothing is left that could be told apart.
    assert values == pytest.approx(np.full((4, 8, 8), 1000.0), abs=1e-3)


def test_a_flat_index_is_direction_row_column() -> None:
    push = cell_push(Workspace(), 4, 1 * 16 + 0 * 4 + 3)
    assert push.start == (0.75, 0.75)
    assert push.direction == (1.0, 0.0)
    assert push.length == 0.5


def test_chunks_hold_every_cell_once() -> None:
    cells = np.arange(100, 123)
    chunks = split(cells, is_exact=False)
    assert max(len(chunk) for chunk in chunks) <= 3
    assert sorted(np.concatenate(chunks)) == list(cells)
    assert split(cells[:0], is_exact=False) == []
