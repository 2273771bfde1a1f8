import time

import numpy as np
import pytest

from singulate.engine import LocalEngine
from singulate.geometry import Poses
from singulate.rewardmap import (
    RewardMap,
    RewardMapCancelledError,
    RewardMapRequest,
    compute_reward_map,
    refine_levels,
    refinement_levels,
)
from singulate.rewardmap.refinement import fill_from


@pytest.mark.parametrize(
    ("resolution", "levels"), [(64, (8, 16, 64)), (16, (8, 16)), (10, (8, 10)), (5, (5,))]
)
def test_levels_end_with_the_requested_one(resolution: int, levels: tuple[int, ...]) -> None:
    assert refinement_levels(resolution) == levels


def test_coarse_comes_first_and_is_refined_in_place(engine: LocalEngine, row_poses: Poses) -> None:
    maps = list(refine_levels(RewardMapRequest(row_poses, resolution=20), engine))
    assert [m.resolution for m in maps[:2]] == [8, 16]
    assert all(m.resolution == 20 for m in maps[2:])
    assert len(maps) > 3
    assert all(np.isfinite(m.values).all() for m in maps)
    progress = [m.progress for m in maps]
    assert progress == sorted(progress)
    assert [m.is_complete for m in maps] == [False] * (len(maps) - 1) + [True]


def test_a_shown_map_is_never_written_again(engine: LocalEngine, row_poses: Poses) -> None:
    seen: list[tuple[RewardMap, bytes]] = []
    compute_reward_map(
        RewardMapRequest(row_poses, resolution=12),
        engine,
        on_progress=lambda m: seen.append((m, m.values.tobytes())),
    )
    assert all(m.values.tobytes() == shown for m, shown in seen)


def test_cancelling_stops_at_once_and_frees_the_workers(
    engine: LocalEngine, row_poses: Poses, pace: float
) -> None:
    request = RewardMapRequest(row_poses, resolution=64)
    asked_at: list[float] = []

    def cancelled() -> bool:
        return bool(asked_at)

    def on_progress(reward_map: RewardMap) -> None:
        if reward_map.resolution == 64:
            asked_at.append(time.monotonic())

    with pytest.raises(RewardMapCancelledError):
        compute_reward_map(request, engine, on_progress, cancelled)
    assert time.monotonic() - asked_at[0] < 0.25 * pace
    compute_reward_map(RewardMapRequest(row_poses, resolution=4), engine)
    assert time.monotonic() - asked_at[0] < 3.0 * pace


def test_closing_the_iterator_cancels_too(
    engine: LocalEngine, row_poses: Poses, pace: float
) -> None:
    maps = refine_levels(RewardMapRequest(row_poses, resolution=64), engine)
    next(maps)
    began = time.monotonic()
    maps.close()  # type: ignore[attr-defined]
    assert time.monotonic() - began < 0.25 * pace


def test_unknown_fine_values_are_those_of_the_coarse_cell() -> None:
    coarse = np.arange(16, dtype=np.float32).reshape(4, 2, 2)
    fine = np.full((4, 4, 4), np.nan, np.float32)
    fine[0, 0, 0] = 99.0
    filled = fill_from(coarse, fine)
    assert filled[0].tolist() == [[99, 0, 1, 1], [0, 0, 1, 1], [2, 2, 3, 3], [2, 2, 3, 3]]
    assert (filled[3, 2:, 2:] == 15).all()
