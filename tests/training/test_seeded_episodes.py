import numpy as np

from singulate.envs import PushEnv
from singulate.training.seeded_episodes import SeededEpisodes

TOWARDS_THE_BLOCKS = 100 + 45


def _episodes() -> SeededEpisodes:
    return SeededEpisodes(PushEnv(scenario="cluster-3", action="grid"), run_seed=4)


def test_episodes_differ_and_repeat_with_the_run() -> None:
    first, second = _episodes(), _episodes()
    scenes = [first.reset()[0] for _ in range(3)]
    assert not np.array_equal(scenes[0], scenes[1])
    assert all(np.array_equal(scene, second.reset(seed=99)[0]) for scene in scenes)


def test_the_middle_of_an_episode_is_restored_bit_for_bit() -> None:
    one, other = _episodes(), _episodes()
    one.reset()
    one.reset()
    observation = one.step(TOWARDS_THE_BLOCKS)[0]
    assert np.array_equal(other.restore(one.state), observation)
    assert other.state == one.state
    assert np.array_equal(other.step(240)[0], one.step(240)[0])
