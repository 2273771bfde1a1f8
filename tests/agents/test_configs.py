import math

import pytest

from singulate.agents.ppo.config import PPOConfig
from singulate.agents.registry import AGENTS, agent_kind
from singulate.agents.trpo.config import TRPOConfig
from singulate.exceptions import InvalidValueError


def test_ppo_defaults_are_table_1() -> None:
    config = PPOConfig()
    assert (config.learning_rate, config.batch_size, config.n_steps, config.n_epochs) == (
        5e-4, 4, 2048, 3,
    )  # fmt: skip


@pytest.mark.parametrize("name", ["dqn", "ppo", "trpo", "sac", "td3"])
def test_agents_have_the_papers_network_and_learning_rate(name: str) -> None:
    config = agent_kind(name).make_config({})
    assert config.net_arch == (128, 64, 64, 32, 16)
    assert config.learning_rate == 5e-4


def test_trpo_differs_from_ppo_in_the_update_alone() -> None:
    ppo, trpo = PPOConfig(), TRPOConfig()
    for name in ("n_steps", "gamma", "gae_lambda", "log_std_init"):
        assert getattr(trpo, name) == getattr(ppo, name)


@pytest.mark.parametrize("name", AGENTS)
def test_settings_survive_json_like_values(name: str) -> None:
    config = agent_kind(name).make_config({"net_arch": [8, 4], "learning_rate": 0.5})
    assert config.net_arch == (8, 4)
    assert config.learning_rate == 0.5


@pytest.mark.parametrize(
    ("name", "key", "value"),
    [
        ("dqn", "learning_rate", 0.0),
        ("dqn", "learning_rate", math.nan),
        ("dqn", "learning_rate", "fast"),
        ("dqn", "batch_size", 2.5),
        ("dqn", "batch_size", True),
        ("dqn", "net_arch", []),
        ("dqn", "net_arch", [0]),
        ("dqn", "net_arch", "128"),
        ("dqn", "symmetries", 1),
        ("dqn", "symmetric_values", 1),
        ("dqn", "final_learning_rate", 1e-5),
        ("dqn", "anneal_steps", 1000),
        ("dqn", "tau", 0.0),
        ("dqn", "tau", 1.5),
        ("dqn", "exploration_final_eps", 1.5),
        ("ppo", "n_steps", 0),
        ("ppo", "batch_size", 4096),
        ("ppo", "gamma", math.inf),
        ("ppo", "gamma", 10**400),
        ("ppo", "speed", 3),
        ("multimodal-ppo", "learning_rate", -1.0),
        ("multimodal-ppo", "final_learning_rate", math.nan),
        ("multimodal-ppo", "anneal_steps", 0),
        ("multimodal-ppo", "num_cells", 10),
        ("multimodal-ppo", "num_cells", True),
        ("multimodal-ppo", "batch_size", 100_000),
        ("multimodal-ppo", "ent_coef", -0.1),
        ("multimodal-ppo", "net_arch", [0]),
        ("trpo", "n_steps", 1),
        ("trpo", "batch_size", 4096),
        ("trpo", "target_kl", 0.0),
        ("trpo", "cg_damping", 0.0),
        ("trpo", "clip_range", 0.2),
        ("sac", "tau", 0.0),
        ("sac", "initial_ent_coef", 0.0),
        ("sac", "target_entropy", math.nan),
        ("sac", "learning_starts", 0),
        ("td3", "policy_delay", 0),
        ("td3", "exploration_noise", -0.1),
        ("td3", "buffer_size", 1.5),
        ("mixture-ppo", "num_components", 0),
        ("mixture-ppo", "num_components", 65),
        ("mixture-ppo", "num_components", 2.0),
        ("mixture-ppo", "clip_range", 0.0),
        ("fourier-ppo", "num_frequencies", 1),
        ("fourier-ppo", "num_frequencies", 33),
        ("fourier-ppo", "num_cells", 48),
        ("fourier-ppo", "num_cells", True),
        ("spatial", "net_arch", [8, 8, 8]),
        ("spatial", "learning_starts", 0),
        ("spatial", "average_decay", 1.5),
        ("spatial", "gamma", 0.9),
    ],
)
def test_bad_settings_name_the_key(name: str, key: str, value: object) -> None:
    with pytest.raises(InvalidValueError, match=key):
        agent_kind(name).make_config({key: value})


def test_a_series_has_no_more_cosines_than_its_grid_has_cells() -> None:
    with pytest.raises(InvalidValueError, match="num_frequencies"):
        agent_kind("fourier-ppo").make_config({"num_frequencies": 20, "num_cells": 16})


def test_unknown_agent_lists_the_known_ones() -> None:
    with pytest.raises(InvalidValueError, match=", ".join(AGENTS)):
        agent_kind("a2c")
