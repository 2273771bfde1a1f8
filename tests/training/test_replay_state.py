import numpy as np
import pytest

from singulate.envs import PushEnv
from singulate.training.replay_state import pack_observations, unpack_observations


@pytest.mark.parametrize("observation", ["distance_map", "mask"])
def test_observations_come_back_bit_for_bit_from_their_masks(observation: str) -> None:
    env = PushEnv(scenario="random-4", observation=observation)
    images = np.stack([env.reset(seed=seed)[0] for seed in range(5)])
    env.close()
    packed = pack_observations(images, observation)
    assert packed.nbytes == 5 * 64 * 64 // 8
    assert np.array_equal(unpack_observations(packed, (64, 64), observation), images)


def test_nothing_packs_to_nothing() -> None:
    packed = pack_observations(np.empty((0, 64, 64), np.float32), "mask")
    assert unpack_observations(packed, (64, 64), "mask").shape == (0, 64, 64)
