"""Gymnasium's and stable-baselines3's own checkers, over every combination."""

import itertools
import warnings

import pytest
from gymnasium.utils.env_checker import check_env as gymnasium_check
from stable_baselines3.common.env_checker import check_env as sb3_check

from singulate.envs import ACTION_ENCODINGS, OBSERVATIONS, PushEnv
from singulate.rewards import REWARDS
from singulate.simulation.scenarios.registry import scenario_names

COMBINATIONS = list(itertools.product(scenario_names(), OBSERVATIONS, ACTION_ENCODINGS, REWARDS))


def check(scenario: str, observation: str, action: str, reward: str) -> None:
    """Raise what the checkers find; their warnings are errors as well."""
    settings = {
        "scenario": scenario,
        "observation": observation,
        "action": action,
        "reward": reward,
        "render_mode": "rgb_array",
    }
    env = PushEnv(**settings)
    with warnings.catch_warnings():
        # A 64 x 64 map is neither a vector nor an 8-bit image, which stable-baselines3 remarks on.
        warnings.filterwarnings("ignore", message="Your observation .* unconventional shape")
        # The checkers cannot know that the environment was made without `gymnasium.make`.
        warnings.filterwarnings("ignore", message=".*not have a `spec`.*")
        gymnasium_check(env, skip_render_check=True)
        sb3_check(env, skip_render_check=True)
    env.close()


@pytest.mark.parametrize(
    "combination", COMBINATIONS[:: len(REWARDS) + 1], ids=lambda combination: "-".join(combination)
)
def test_checkers_pass_for_a_fifth_of_all_combinations_that_meets_every_choice(combination):
    check(*combination)


def test_that_fifth_meets_every_choice_and_every_pair_of_them_but_for_scenarios():
    fifth = COMBINATIONS[:: len(REWARDS) + 1]
    for first, second in itertools.combinations(range(4), 2):
        pairs = {(c[first], c[second]) for c in COMBINATIONS}
        if first > 0:
            assert {(c[first], c[second]) for c in fifth} == pairs
        assert {c[first] for c in fifth} == {c[first] for c in COMBINATIONS}


@pytest.mark.slow
@pytest.mark.parametrize("scenario", scenario_names())
def test_checkers_pass_for_all_combinations(scenario):
    for combination in COMBINATIONS:
        if combination[0] == scenario:
            check(*combination)
