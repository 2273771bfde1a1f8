"""Many environments at once, as Gymnasium and stable-baselines3 run them."""

import gymnasium
import numpy as np
import pytest
from stable_baselines3.common.vec_env import DummyVecEnv, SubprocVecEnv

import singulate  # noqa: F401  registers the environment


def make():
    return gymnasium.make("singulate/Push-v0", scenario="random-2", action="grid")


@pytest.mark.parametrize("mode", ["sync", "async"])
def test_gymnasium_vectorises(mode):
    kwargs = {"context": "spawn"} if mode == "async" else {}
    envs = gymnasium.make_vec(
        "singulate/Push-v0",
        num_envs=2,
        vectorization_mode=mode,
        vector_kwargs=kwargs,
        scenario="random-2",
        action="grid",
    )
    observations, _ = envs.reset(seed=[3, 4])
    alone = make()
    for i, seed in enumerate((3, 4)):
        assert (alone.reset(seed=seed)[0] == observations[i]).all()
    _, rewards, terminated, _, infos = envs.step(np.array([0, 399]))
    assert rewards.shape == (2,)
    assert terminated.all()
    assert infos["num_segments"].tolist() == [1, 1]
    envs.close()
    alone.close()


def test_stable_baselines3_vectorises():
    results = []
    for kind in (DummyVecEnv, SubprocVecEnv):
        kwargs = {"start_method": "spawn"} if kind is SubprocVecEnv else {}
        envs = kind([make, make], **kwargs)
        envs.seed(5)
        first = envs.reset()
        second, rewards, dones, _ = envs.step(np.array([44, 145]))
        results.append((first, second, rewards.astype(np.float32)))
        assert dones.all()
        envs.close()
    for dummy, subprocess in zip(*results, strict=True):
        assert (dummy == subprocess).all()
