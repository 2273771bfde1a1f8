import gymnasium
import numpy as np
import pytest

from singulate.agents.autoencoder.scenes import draw_maps
from singulate.exceptions import InvalidValueError


def test_maps_are_what_an_environment_shows_of_the_same_scenes() -> None:
    """Both draw their scenes from the generator that they are given, one after the other."""
    env = gymnasium.make("singulate/Push-v0", scenario="cluster-3").unwrapped
    env.np_random = np.random.default_rng(6)
    shown = np.stack([env.reset()[0] for _ in range(3)])
    env.close()
    maps = draw_maps("cluster-3", 3, np.random.default_rng(6))
    assert (maps.dtype, maps.shape) == (np.float32, (3, 64, 64))
    assert np.array_equal(maps, shown)
    assert not np.array_equal(maps[0], maps[1])


def test_an_unknown_scenario_is_refused() -> None:
    with pytest.raises(InvalidValueError, match="moon-2"):
        draw_maps("moon-2", 1, np.random.default_rng(0))
