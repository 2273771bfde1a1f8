import numpy as np
import pytest
from gymnasium import spaces

from singulate.agents.policy import FloatMap
from singulate.agents.spatial.replay import PushMemory, as_distance_maps, directions_of
from singulate.envs import PointActions
from singulate.geometry import Direction, Push, Workspace

SPACE = spaces.Box(-1.0, 91.0, (64, 64), np.float32)
ENCODING = PointActions(Workspace())


def _filled(image: FloatMap, best_share: float, num_pushes: int = 100) -> PushMemory:
    memory = PushMemory(
        200, SPACE, ENCODING.space, device="cpu",
        seed=5, best_share=best_share, observation="distance_map",
    )  # fmt: skip
    for index in range(num_pushes):
        direction = Direction(index % 4)
        push = Push.cardinal((0.1, 0.4), direction, 0.5)
        action, reward = ENCODING.encode(push)[None], np.array([float(index)])
        memory.add(image[None], image[None], action, reward, np.array([True]), [{}])
    return memory


def test_equal_seeds_sample_equally(image: FloatMap) -> None:
    first, second = (_filled(image, 0.25).sample_pushes(16) for _ in range(2))
    assert all(bool((a == b).all()) for a, b in zip(first, second, strict=True))


def test_the_best_tenth_is_drawn_more_often(image: FloatMap) -> None:
    rewards = _filled(image, 0.25).sample_pushes(2000).rewards.numpy()
    assert (rewards >= 90).mean() == pytest.approx(0.25 + 0.75 * 0.1, abs=0.03)
    rewards = _filled(image, 0.0).sample_pushes(2000).rewards.numpy()
    assert (rewards >= 90).mean() == pytest.approx(0.1, abs=0.03)


def test_few_pushes_are_drawn_alike(image: FloatMap) -> None:
    rewards = _filled(image, 0.5, num_pushes=3).sample_pushes(600).rewards.numpy()
    assert np.bincount(rewards.astype(int)).min() > 150


def test_a_window_shows_the_start_of_its_push(image: FloatMap) -> None:
    batch = _filled(image, 0.25).sample_pushes(64)
    row, column = Workspace().xy_to_row_col(0.1, 0.4)
    canvases, pixels = batch.canvases.numpy(), batch.pixels.numpy()
    assert canvases.shape == (64, 36, 36)
    cells = np.rint(pixels).astype(int)
    seen = canvases[np.arange(64), 24 + cells[:, 0], 16 + cells[:, 1]]
    assert np.abs(seen - image[row, column]).max() <= 1.5


def test_directions_are_read_from_actions() -> None:
    actions = [ENCODING.encode(Push.cardinal((0.0, 0.0), d, 0.5)) for d in Direction]
    assert directions_of(np.array(actions, dtype=np.float64)).tolist() == list(Direction)
    assert directions_of(np.array([[0.0, 0.0, 1.0]])).tolist() == [Direction.LEFT]


def test_masks_become_distance_maps(image: FloatMap) -> None:
    masks = (image < 0.0).astype(np.float32)[None]
    assert np.array_equal(as_distance_maps(masks, "mask")[0], image)
