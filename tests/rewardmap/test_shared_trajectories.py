import numpy as np

from singulate.engine import LocalEngine
from singulate.geometry import Direction, Poses
from singulate.rewardmap import RewardMapRequest, compute_reward_map
from singulate.rewardmap.plain_pushes import plain_pushes
from singulate.rewardmap.shared_trajectories import split_into_lines


def test_the_map_is_that_of_plain_pushes_but_for_few_starts(
    engine: LocalEngine, pushed_poses: Poses
) -> None:
    request = RewardMapRequest(pushed_poses, resolution=24)
    shared = compute_reward_map(request, engine).values
    plain = compute_reward_map(request, engine, algorithm=plain_pushes).values
    is_touching = plain != np.median(plain)
    assert np.isfinite(shared).all()
    assert (shared[plain == -100.0] == -100.0).all()
    assert np.isclose(shared, plain, atol=40.0)[is_touching].mean() > 0.9


def test_the_number_of_workers_changes_nothing(engine: LocalEngine, row_poses: Poses) -> None:
    request = RewardMapRequest(row_poses, resolution=20)
    two = compute_reward_map(request, engine)
    with LocalEngine(num_workers=1) as alone:
        one = compute_reward_map(request, alone)
    assert one.values.tobytes() == two.values.tobytes()


def test_lines_hold_every_open_cell_once_and_follow_the_direction() -> None:
    is_open = np.random.default_rng(0).random((4, 6, 6)) < 0.5
    lines = split_into_lines(is_open)
    assert sorted(np.concatenate(lines)) == list(np.flatnonzero(is_open))
    for line in lines:
        directions, rest = np.divmod(line, 36)
        across = rest % 6 if Direction(int(directions[0])).vector[0] == 0.0 else rest // 6
        assert len(set(directions)) == len(set(across)) == 1
