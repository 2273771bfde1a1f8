from pathlib import Path

import numpy as np
import pytest

from singulate.exceptions import InvalidValueError
from singulate.geometry import Block, BlockPose, standing_pose
from singulate.rewardmap import RewardMap, RewardMapRequest, load_reward_map

POSES = (standing_pose(Block(0.1, 0.2, 0.15, 0.3)), standing_pose(Block(-0.5, 0.2)))


def some_map() -> RewardMap:
    values = np.random.default_rng(0).normal(size=(4, 6, 6)).astype(np.float32)
    return RewardMap(values, 1.0, POSES, "paper", 0.1)


def test_a_saved_map_is_read_back_as_it_was(tmp_path: Path) -> None:
    reward_map = some_map()
    reward_map.save_npz(tmp_path / "map.npz")
    loaded = load_reward_map(tmp_path / "map.npz")
    np.testing.assert_array_equal(loaded.values, reward_map.values)
    assert loaded.poses == POSES
    assert (loaded.reward, loaded.goal_separation, loaded.progress) == ("paper", 0.1, 1.0)
    assert [p.name for p in tmp_path.iterdir()] == ["map.npz"]


def test_a_directory_that_is_not_there_is_one_clear_line(tmp_path: Path) -> None:
    with pytest.raises(InvalidValueError, match=r"out: .*map\.npz"):
        some_map().save_npz(tmp_path / "nowhere" / "map.npz")


@pytest.mark.parametrize("content", [b"", b"not a map", b"PK\x03\x04 truncated"])
def test_a_foreign_file_is_refused_in_one_line(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "map.npz"
    path.write_bytes(content)
    with pytest.raises(InvalidValueError) as caught:
        load_reward_map(path)
    assert "\n" not in str(caught.value)


def test_a_map_of_another_shape_is_refused(tmp_path: Path) -> None:
    np.savez(tmp_path / "map.npz", reward_map=np.zeros((3, 2)))
    with pytest.raises(InvalidValueError, match="shape"):
        load_reward_map(tmp_path / "map.npz")


NAN_POSE = BlockPose((float("nan"), 0.0, 0.1), (0.0, 0.0, 0.0, 1.0), 0.2)


@pytest.mark.parametrize(
    ("values", "key"),
    [
        ({"resolution": 0}, "resolution"),
        ({"resolution": 257}, "resolution"),
        ({"goal_separation": float("nan")}, "goal_separation"),
        ({"reward": "gold"}, "reward"),
        ({"poses": (NAN_POSE,)}, "poses"),
    ],
)
def test_a_request_is_checked(values: dict[str, object], key: str) -> None:
    with pytest.raises(InvalidValueError, match=key):
        RewardMapRequest(**({"poses": POSES} | values))  # type: ignore[arg-type]
