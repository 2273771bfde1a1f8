import numpy as np
from gymnasium import spaces

from singulate.agents.dqn.replay import SymmetricReplayBuffer
from singulate.agents.dqn.symmetry import NUM_SYMMETRIES, action_table, transform_images

SPACE = spaces.Box(-1.0, 91.0, (64, 64), np.float32)


def _filled(symmetries: bool, num_pushes: int = 20) -> SymmetricReplayBuffer:
    buffer = SymmetricReplayBuffer(
        30, SPACE, spaces.Discrete(400), seed=5, symmetries=symmetries, device="cpu"
    )
    rng = np.random.default_rng(0)
    for index in range(num_pushes):
        image = rng.uniform(0, 50, (1, 64, 64)).astype(np.float32)
        reward = np.array([float(index)])
        buffer.add(image, image, np.array([index]), reward, np.array([True]), [{}])
    return buffer


def test_equal_seeds_sample_equally() -> None:
    first, second = _filled(True).sample(8), _filled(True).sample(8)
    assert np.array_equal(first.observations, second.observations)
    assert np.array_equal(first.actions, second.actions)


def test_without_symmetries_pushes_come_back_as_they_were() -> None:
    buffer = _filled(False)
    batch = buffer.sample(16)
    rows = batch.rewards[:, 0].long().numpy()
    assert np.array_equal(batch.actions[:, 0], rows)
    assert np.array_equal(batch.observations, buffer.observations[rows, 0])


def test_symmetries_move_image_and_action_alike_but_not_the_reward() -> None:
    buffer, table = _filled(True), action_table(10)
    batch = buffer.sample(64)
    met = set()
    for image, action, reward in zip(
        batch.observations.numpy(), batch.actions[:, 0], batch.rewards[:, 0], strict=True
    ):
        index = int(reward)
        (fitting,) = [
            symmetry
            for symmetry in range(NUM_SYMMETRIES)
            if table[symmetry, index] == action
            and np.array_equal(transform_images(buffer.observations[index], symmetry)[0], image)
        ]
        met.add(fitting)
    assert met == set(range(NUM_SYMMETRIES))
